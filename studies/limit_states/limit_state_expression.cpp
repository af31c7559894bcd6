#include "studies/limit_states/limit_state_expression.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <sstream>

#include "engine/base/error.h"
#include "engine/base/number_text.h"
#include "engine/config/document.h"
#include "engine/config/nearest_name.h"
#include "engine/config/table.h"
#include "studies/limit_states/limit_state_reader.h"

namespace gurney::study {
namespace {

using config::Node;

std::string plain(std::string_view text) { return std::string(trimmed(text)); }

/// Takes what stands before `mark` from the start of `text`.
std::optional<std::string> take_before(std::string_view& text, std::string_view mark) {
  const auto at = text.find(mark);
  if (at == std::string_view::npos) return {};
  std::string before = plain(text.substr(0, at));
  text.remove_prefix(at + mark.size());
  return before;
}

/// A table [[limit_state]] that grows key by key.
class StateTable {
 public:
  void add(const std::string& key, const std::string& text) {
    Node value;
    value.kind = Node::Kind::kText;
    value.text = text;
    add(key, std::move(value));
  }
  void add(const std::string& key, double number) {
    Node value;
    value.kind = Node::Kind::kNumber;
    value.number = number;
    if (number == static_cast<double>(static_cast<int>(number))) {
      value.kind = Node::Kind::kInteger;
      value.integer = static_cast<int>(number);
    }
    add(key, std::move(value));
  }
  Node root() const {
    Node list, root;
    list.kind = Node::Kind::kArray;
    list.key = "limit_state";
    list.elements.push_back(table_);
    root.elements.push_back(list);
    return root;
  }

 private:
  void add(const std::string& key, Node value) {
    value.key = key;
    table_.elements.push_back(std::move(value));
  }
  Node table_;
};

/// The keys of a place: an item, a marked point (or item/point), a zone or a tether.
void add_place(const std::string& place, const Places& places, StateTable& table) {
  const auto in = [&](const std::vector<std::string>& names) {
    return std::ranges::find(names, place) != names.end();
  };
  std::vector<std::string> kinds, known;
  for (const auto* names : {&places.items, &places.zones, &places.tethers})
    known.insert(known.end(), names->begin(), names->end());
  if (in(places.items)) kinds.push_back("item");
  if (in(places.zones)) kinds.push_back("zone");
  if (in(places.tethers)) kinds.push_back("tether");
  std::string item_of_point;
  bool point = false;
  for (const auto& [item, name] : places.points) {
    known.push_back(item + "/" + name);
    if (place != known.back() && place != name) continue;
    if (!point) kinds.push_back("point");
    point = true;
    if (place == known.back()) item_of_point = item;
  }
  require(!kinds.empty(), fmt::format("no item, marked point, zone or tether '{}'{}", place,
                                      config::suggestion(place, known)) +
                              "; a name of the limit state stands before =, as in 'far = "
                              "peak_displacement > 0.2 m'");
  require(kinds.size() == 1, fmt::format("'{}' is the name of {}; state which in a file: "
                                         "--limit-states FILE",
                                         place, fmt::join(kinds, " and of ")));
  if (!item_of_point.empty()) table.add("item", item_of_point);
  table.add(kinds.front(), item_of_point.empty() ? place : place.substr(item_of_point.size() + 1));
}

/// `peak_displacement > 0.2 m`, or the name of an event.
void add_condition(std::string_view text, StateTable& table) {
  const auto sign = text.find_first_of("<>");
  if (sign == std::string_view::npos) {
    table.add("event", plain(text));
    return;
  }
  const bool above = text[sign] == '>';
  std::string_view right = text.substr(sign + 1);
  require(!right.starts_with('='),
          fmt::format("a limit is exceeded beyond its value: {}, not {}=", text[sign], text[sign]));
  right = trimmed(right);
  const std::optional<double> limit = take_number(right);
  require(limit.has_value(), fmt::format("a number must follow {}, and its unit", text[sign]));
  table.add("demand", plain(text.substr(0, sign)));
  table.add(above ? "above" : "below", *limit);
  if (const std::string unit = plain(right); !unit.empty()) table.add("unit", unit);
}

/// `at least 3 items: `
void add_count(std::string_view& text, StateTable& table) {
  constexpr std::string_view kAtLeast = "at least ";
  if (!text.starts_with(kAtLeast)) return;
  std::string_view rest = text.substr(kAtLeast.size());
  const std::optional<double> count = take_number(rest);
  const std::optional<std::string> of = take_before(rest, ":");
  require(count && of == "items", "must be as in: at least 3 items: peak_displacement > 1 m");
  table.add("at_least", *count);
  text = trimmed(rest);
}

/// The name, empty where none is given.
std::string take_name(std::string_view& text) {
  const auto equals = text.find('=');
  if (equals == std::string_view::npos || equals > text.find_first_of("<>")) return {};
  std::string name = *take_before(text, "=");
  require(!name.empty(), "a name must stand before =");
  text = trimmed(text);
  return name;
}

LimitState state_of(std::string_view text, const Places& places, const std::string& path) {
  StateTable table;
  text = trimmed(text);
  require(!text.empty(), "must be as in: peak_displacement > 0.2 m");
  const std::string name = take_name(text);
  table.add("name", name);
  add_count(text, table);
  if (const auto place = take_before(text, ": ")) add_place(*place, places, table);
  add_condition(text, table);
  config::Document document(table.root(), config::Document("", path));
  config::Table root = document.root();
  LimitState state = read_limit_states(root).front();
  document.finish();
  if (name.empty()) state.name = state.words;
  return state;
}

/// Lines `PATH:1:1: limit_state[0].demand = ...` without what the user did not type.
std::string as_typed(const std::string& message, const std::string& path) {
  const std::string made = path + ":1:1: ", key = "limit_state[0]";
  std::istringstream lines(message);
  std::string text;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(made)) line.erase(0, made.size());
    if (line.starts_with(key)) line.erase(0, key.size());
    if (line.starts_with('.')) line.erase(0, 1);
    text += (text.empty() ? "" : "\n") + path + ": " + line;
  }
  return text;
}

}  // namespace

std::string option_of(const std::string& line) { return "--limit-state \"" + line + "\""; }

LimitState read_limit_state_expression(const std::string& line, const Places& places) {
  const std::string path = option_of(line);
  try {
    return state_of(line, places, path);
  } catch (const Error& error) {
    throw Error(as_typed(error.what(), path));
  }
}

}  // namespace gurney::study
