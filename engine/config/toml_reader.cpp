#include "engine/config/toml_reader.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cctype>
#include <sstream>
#include <string_view>

#include "engine/base/error.h"
#include "engine/base/memory.h"
#include "engine/config/toml_depth.h"

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

/// The bare word in which an error lies, such as `no` after `=`, and its place; empty: none.
std::string bare_word(const std::string& text, Place& place) {
  std::istringstream lines(text);
  std::string line;
  for (int i = 0; i < place.line && std::getline(lines, line);) ++i;
  const auto is_letter = [&](std::size_t at) {
    return at < line.size() &&
           (std::isalnum(static_cast<unsigned char>(line[at])) || line[at] == '_');
  };
  std::size_t begin =
      std::min(line.size(), static_cast<std::size_t>(std::max(1, place.column) - 1));
  if (!is_letter(begin) && begin > 0) --begin;  // the parser may stand behind it
  while (begin > 0 && is_letter(begin - 1)) --begin;
  std::size_t end = begin;
  while (is_letter(end)) ++end;
  const std::string word = line.substr(begin, end - begin);
  const std::size_t before = line.find_last_not_of(" \t", begin == 0 ? 0 : begin - 1);
  const bool is_value = begin > 0 && before != std::string::npos &&
                        std::string_view("=[,").find(line[before]) != std::string_view::npos;
  if (!is_value || word.empty() || !std::isalpha(static_cast<unsigned char>(word[0]))) return "";
  place.column = static_cast<int>(begin) + 1;
  return word;
}

/// Whether the line of an error begins a table and does not end its name: `[floor`; its end then is
/// the place.
bool is_open_header(const std::string& text, Place& place) {
  std::istringstream lines(text);
  std::string line;
  // The parser may stand on the line after the one that lacks its bracket.
  for (int i = 1; i <= place.line && std::getline(lines, line); ++i) {
    const std::size_t first = line.find_first_not_of(" \t"), name = line.find_first_not_of("[ \t");
    if (first == std::string::npos || line[first] != '[' || i + 1 < place.line) continue;
    const auto is_name = [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '.'; };
    const std::string rest = name == std::string::npos ? "" : line.substr(name);
    if (!rest.empty() && std::ranges::all_of(rest, is_name)) {
      place = {i, static_cast<int>(line.size()) + 1};
      return true;
    }
  }
  return false;
}

std::string explained(const std::string& text, const std::string& description, Place& place) {
  if (is_open_header(text, place)) return "']' is missing at the end of the name of a table";
  if (description.find("cannot redefine existing table") != std::string::npos)
    return description + "; of several tables with one name each begins with [[name]]";
  const std::string word = bare_word(text, place);
  if (word.empty() || word == "true" || word == "false") return description;
  return "invalid value `" + word + "`; expected true, false, a number, or text in quotes";
}

}  // namespace

Node read_toml(const std::string& text, const std::string& name) {
  if (const std::optional<Place> place = find_too_deep(text))
    throw Error(fmt::format("{}:{}:{}: nested more than {} deep", name, place->line, place->column,
                            kDeepestNesting));
  // toml++ ends the process where an allocation fails: its functions are noexcept. Its trees take 20 to 41
  // times the bytes of their text (keys, tables; `{},` the most), and more while an array grows.
  require_memory((1 << 20) + 64 * text.size());
  try {
    Node root = node_of(toml::parse(text, name));
    root.place = {};
    return root;
  } catch (const toml::parse_error& error) {
    Place place = place_of(error.source());
    const std::string reason = explained(text, std::string(error.description()), place);
    throw Error(
        fmt::format("{}:{}:{}: not valid TOML: {}", name, place.line, place.column, reason));
  }
}

}  // namespace gurney::config
