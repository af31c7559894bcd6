#include "engine/base/config/toml_reader.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <sstream>

#include "engine/base/config/toml_depth.h"
#include "engine/base/error.h"

namespace gurney::config {
namespace {

Place place_of(const toml::source_region& source) {
  return {static_cast<int>(source.begin.line), static_cast<int>(source.begin.column)};
}

template <typename T>
std::string as_written(const T& value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

Node node_of(const toml::node& source) {
  Node node;
  node.place = place_of(source.source());
  if (const auto* table = source.as_table()) {
    for (const auto& [key, value] : *table) {
      Node element = node_of(value);
      element.key = std::string(key.str());
      element.key_place = place_of(key.source());
      node.elements.push_back(std::move(element));
    }
  } else if (const auto* array = source.as_array()) {
    node.kind = Node::Kind::kArray;
    for (const toml::node& value : *array) node.elements.push_back(node_of(value));
  } else if (const auto* boolean = source.as_boolean()) {
    node.kind = Node::Kind::kBoolean;
    node.boolean = boolean->get();
  } else if (const auto* integer = source.as_integer()) {
    node.kind = Node::Kind::kInteger;
    node.integer = integer->get();
    node.number = static_cast<double>(node.integer);
  } else if (const auto* number = source.as_floating_point()) {
    node.kind = Node::Kind::kNumber;
    node.number = number->get();
  } else if (const auto* text = source.as_string()) {
    node.kind = Node::Kind::kText;
    node.text = text->get();
  } else {
    node.kind = Node::Kind::kOther;
    source.visit([&](const auto& value) { node.text = as_written(value); });
  }
  return node;
}

}  // namespace

Node read_toml(const std::string& text, const std::string& name) {
  if (const std::optional<Place> place = find_too_deep(text))
    throw Error(fmt::format("{}:{}:{}: nested more than {} deep", name, place->line, place->column,
                            kDeepestNesting));
  try {
    Node root = node_of(toml::parse(text, name));
    root.place = {};
    return root;
  } catch (const toml::parse_error& error) {
    const Place place = place_of(error.source());
    throw Error(fmt::format("{}:{}:{}: not valid TOML: {}", name, place.line, place.column,
                            std::string(error.description())));
  }
}

}  // namespace gurney::config
