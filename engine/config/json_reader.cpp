#include "engine/config/json_reader.h"

#include <fmt/format.h>

#include <cstdint>
#include <nlohmann/json.hpp>
#include <set>

#include "engine/base/error.h"
#include "engine/config/toml_depth.h"

namespace gurney::config {
namespace {

using Json = nlohmann::ordered_json;

std::string escaped(const std::string& key) {
  std::string text;
  for (const char c : key) text += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  return text;
}

Node node_of(const Json& source, const std::string& pointer, std::vector<std::string>& pointers) {
  Node node;
  pointers.push_back(pointer);
  node.place = {static_cast<int>(pointers.size()), 1};
  if (source.is_object()) {
    for (const auto& [key, value] : source.items()) {
      Node element = node_of(value, pointer + '/' + escaped(key), pointers);
      element.key = key;
      element.key_place = element.place;
      node.elements.push_back(std::move(element));
    }
  } else if (source.is_array()) {
    node.kind = Node::Kind::kArray;
    for (std::size_t i = 0; i < source.size(); ++i)
      node.elements.push_back(node_of(source[i], fmt::format("{}/{}", pointer, i), pointers));
  } else if (source.is_boolean()) {
    node.kind = Node::Kind::kBoolean;
    node.boolean = source.get<bool>();
  } else if (source.is_number_unsigned() && source.get<std::uint64_t>() >> 63 != 0) {
    node.kind = Node::Kind::kNumber;  // beyond whole numbers of TOML
    node.number = source.get<double>();
  } else if (source.is_number_integer()) {
    node.kind = Node::Kind::kInteger;
    node.integer = source.get<long long>();
    node.number = static_cast<double>(node.integer);
  } else if (source.is_number()) {
    node.kind = Node::Kind::kNumber;
    node.number = source.get<double>();
  } else if (source.is_string()) {
    node.kind = Node::Kind::kText;
    node.text = source.get<std::string>();
  } else {
    node.kind = Node::Kind::kOther;
    node.text = source.dump();
  }
  return node;
}

}  // namespace

JsonTree read_json(const std::string& text, const std::string& name) {
  std::vector<std::set<std::string>> keys;
  const auto check_event = [&](int depth, Json::parse_event_t event, Json& value) {
    require(depth <= kDeepestNesting,
            fmt::format("{}: nested more than {} deep", name, kDeepestNesting));
    if (event == Json::parse_event_t::object_start) keys.emplace_back();
    if (event == Json::parse_event_t::object_end) keys.pop_back();
    if (event == Json::parse_event_t::key && !keys.back().insert(value.get<std::string>()).second)
      throw Error(fmt::format("{}: the key \"{}\" comes twice in one object", name,
                              value.get<std::string>()));
    return true;
  };
  try {
    JsonTree tree;
    tree.root = node_of(Json::parse(text, check_event), "", tree.pointers);
    require(tree.root.kind == Node::Kind::kTable, name + ": must be a JSON object");
    return tree;
  } catch (const Json::exception& error) {
    const std::string words = error.what();
    throw Error(name + ": not valid JSON: " + words.substr(words.find("] ") + 2));
  }
}

}  // namespace gurney::config
