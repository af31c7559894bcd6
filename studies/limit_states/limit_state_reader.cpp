#include "studies/limit_states/limit_state_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>

#include "engine/base/error.h"
#include "engine/base/names.h"
#include "engine/base/number_text.h"
#include "engine/base/unit_table.h"
#include "engine/config/document.h"
#include "engine/config/nearest_name.h"
#include "engine/config/table.h"
#include "studies/results/columns.h"

namespace gurney::study {
namespace {

using config::Range;
using config::Table;

struct NamedColumn {
  std::string name, units;
};

template <class Row>
std::vector<NamedColumn> named(std::span<const TableColumn<Row>> columns) {
  std::vector<NamedColumn> result;
  for (const TableColumn<Row>& column : columns) result.push_back({column.name, column.units});
  return result;
}

std::vector<NamedColumn> columns_of(Quantity::Of of) {
  switch (of) {
    case Quantity::Of::kPoint:
      return named(point_demand_columns());
    case Quantity::Of::kZone:
      return named(zone_columns());
    case Quantity::Of::kTether:
      return named(tether_columns());
    case Quantity::Of::kItem:
      break;
  }
  return named(demand_columns());
}

/// Events by name: the column that is -1 while they did not happen.
struct Event {
  const char* name;
  Quantity::Of of;
  const char* column;
  double above;
};
constexpr std::array kEvents = {Event{"overturned", Quantity::Of::kItem, "time_of_overturning", 0},
                                Event{"toppled", Quantity::Of::kItem, "time_of_toppling", 0},
                                Event{"fell", Quantity::Of::kItem, "time_of_fall", 0},
                                Event{"released", Quantity::Of::kItem, "time_of_release", 0},
                                Event{"impact", Quantity::Of::kItem, "impacts", 0},
                                Event{"lifted", Quantity::Of::kItem, "most_wheels_lifted", 0},
                                Event{"entered", Quantity::Of::kZone, "time_of_entry", 0},
                                Event{"occupied at end", Quantity::Of::kZone, "occupied_at_end", 0},
                                Event{"taut", Quantity::Of::kTether, "time_taut", 0},
                                Event{"broken", Quantity::Of::kTether, "time_broken", 0}};

Quantity read_place(Table& in) {
  Quantity quantity;
  static constexpr std::array kParts = {std::pair{"point", Quantity::Of::kPoint},
                                        std::pair{"zone", Quantity::Of::kZone},
                                        std::pair{"tether", Quantity::Of::kTether}};
  int given = 0;
  for (const auto& [key, of] : kParts) {
    if (!in.has(key)) continue;
    quantity.of = of;
    quantity.part = in.text(key);
    ++given;
  }
  if (given > 1) in.note("point", ": one of point, zone and tether, not several");
  if (quantity.of == Quantity::Of::kItem || quantity.of == Quantity::Of::kPoint)
    quantity.item = in.text("item", "");
  return quantity;
}

void read_event(Table& in, LimitState& state) {
  std::vector<std::string> names;
  std::vector<const Event*> events;
  for (const Event& event : kEvents)
    if (event.of == state.quantity.of) {
      names.push_back(event.name);
      events.push_back(&event);
    }
  if (names.empty()) {
    in.has("event");
    in.note("event", ": a marked point has no events; state a demand");
    return;
  }
  const Event& event = *events[in.choice("event", names)];
  state.quantity.column = event.column;
  state.limit = event.above;
  // A time is 0 at the start and -1 for never.
  if (std::string(event.column).starts_with("time")) state.limit = -0.5;
  state.words = event.name;
}

void read_demand(Table& in, LimitState& state) {
  const std::vector<NamedColumn> columns = columns_of(state.quantity.of);
  const std::vector<std::string> names = names_of(columns);
  const std::size_t errors = in.document().errors();
  const NamedColumn& column = columns[in.choice("demand", names)];
  state.quantity.column = column.name;
  if (in.document().errors() > errors) {
    for (const char* key : {"above", "below", "unit"}) in.has(key);
    return;
  }
  if (in.has("above") == in.has("below")) {
    in.note("above", ": must be given, or below, not both");
    for (const char* key : {"above", "below", "unit"}) in.has(key);
    return;
  }
  const bool above = in.has("above");
  state.kind = above ? LimitState::Kind::kAbove : LimitState::Kind::kBelow;
  const double limit = in.number(above ? "above" : "below", Range::any());
  double in_si = 1;
  std::string unit;
  const std::vector<std::string> units = units_in_files(column.units);
  if (units.empty()) {
    if (in.has("unit")) in.note("unit", ": " + column.name + " is a pure number");
  } else {
    const std::string& name = units[in.choice("unit", units)];
    unit = " " + name;
    in_si = gurney::in_si(name);
  }
  state.limit = limit * in_si;
  state.words = fmt::format("{} {} {:g}{}", column.name, above ? '>' : '<', limit, unit);
}

std::optional<std::vector<std::size_t>> read_parts(Table& in, const std::string& key,
                                                   const std::vector<LimitState>& before) {
  if (!in.has(key)) return {};
  std::vector<std::size_t> parts;
  for (const std::string& name : in.texts(key)) {
    try {
      parts.push_back(index_of(before, name));
    } catch (const Error& error) {
      in.note(key, std::string(": ") + error.what());
    }
  }
  if (in.is_array(key) && in.texts(key).size() < 2)
    in.note(key, ": must name 2 or more limit states that stand before this one");
  return parts;
}

void add_place(LimitState& state) {
  std::string place = state.quantity.item;
  if (!state.quantity.part.empty()) place += (place.empty() ? "" : "/") + state.quantity.part;
  if (!place.empty()) state.words = place + ": " + state.words;
}

/// How many it takes, of `most` where that is known.
void read_at_least(Table& in, LimitState& state, const std::string& of, std::size_t most) {
  if (!in.has("at_least")) return;
  state.at_least = in.integer("at_least", 1, static_cast<int>(most), 1);
  if (state.at_least > 1)
    state.words = fmt::format("at least {} {}: {}", state.at_least, of, state.words);
}

LimitState read_state(Table& in, const std::vector<LimitState>& before) {
  LimitState state;
  state.name = in.text("name");
  for (const auto& [key, kind] :
       {std::pair{"any_of", LimitState::Kind::kAny}, std::pair{"all_of", LimitState::Kind::kAll}})
    if (auto parts = read_parts(in, key, before)) {
      state.kind = kind;
      state.parts = *parts;
      for (const std::size_t part : state.parts)
        state.words += (state.words.empty()              ? ""
                        : kind == LimitState::Kind::kAny ? " or "
                                                         : " and ") +
                       before[part].name;
      if (kind == LimitState::Kind::kAny)
        read_at_least(in, state, "of", std::max<std::size_t>(1, state.parts.size()));
      else if (in.has("at_least"))
        in.note("at_least", ": must go with any_of, not with all_of");
      return state;
    }
  state.quantity = read_place(in);
  if (in.has("event") == in.has("demand")) {
    in.note("demand", ": must be given, or event, or any_of, or all_of; one of them");
    for (const char* key : {"event", "demand", "above", "below", "unit", "at_least"}) in.has(key);
    return state;
  }
  if (in.has("event"))
    read_event(in, state);
  else
    read_demand(in, state);
  add_place(state);
  const bool one = !state.quantity.item.empty() || !state.quantity.part.empty();
  if (one && in.has("at_least"))
    in.note("at_least", ": must not go with a place; it counts the items of the scene");
  else
    read_at_least(in, state, "items", 1000);
  return state;
}

}  // namespace

std::vector<LimitState> read_limit_states(Table& root) {
  std::vector<LimitState> states;
  for (Table& in : root.tables("limit_state")) {
    LimitState state = read_state(in, states);
    const bool known = std::ranges::any_of(
        states, [&](const LimitState& each) { return each.name == state.name; });
    if (known) in.note("name", " = \"" + state.name + "\": two limit states have this name");
    states.push_back(std::move(state));
  }
  return states.empty() ? default_limit_states() : states;
}

std::vector<std::size_t> read_performance(Table& in, const std::vector<LimitState>& states) {
  std::vector<std::size_t> levels;
  for (const std::string& name : in.texts("performance")) {
    try {
      const std::size_t level = index_of(states, name);
      if (std::ranges::find(levels, level) != levels.end())
        in.note("performance", ": \"" + name + "\" comes twice");
      levels.push_back(level);
    } catch (const Error& error) {
      in.note("performance", std::string(": ") + error.what());
    }
  }
  return levels;
}

std::size_t index_of(const std::vector<LimitState>& states, const std::string& name) {
  const std::vector<std::string> names = names_of(states);
  const auto found = std::ranges::find(names, name);
  require(found != names.end(), "no limit state '" + name + "'" + config::suggestion(name, names));
  return static_cast<std::size_t>(found - names.begin());
}

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
    if (std::abs(number) <= std::numeric_limits<int>::max() && number == std::floor(number)) {
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
