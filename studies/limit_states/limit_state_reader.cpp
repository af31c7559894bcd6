#include "studies/limit_states/limit_state_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "engine/base/error.h"
#include "engine/base/units.h"
#include "engine/config/nearest_name.h"
#include "studies/results/columns.h"

namespace gurney::study {
namespace {

using config::Range;
using config::Table;

struct Unit {
  const char* name;
  const char* si;
  double in_si;
};
constexpr std::array kUnits = {Unit{"m", "m", 1},
                               Unit{"cm", "m", 0.01},
                               Unit{"mm", "m", 0.001},
                               Unit{"m/s", "m/s", 1},
                               Unit{"cm/s", "m/s", 0.01},
                               Unit{"m/s2", "m/s2", 1},
                               Unit{"g", "m/s2", kStandardGravity},
                               Unit{"rad", "rad", 1},
                               Unit{"deg", "rad", kRadiansPerDegree},
                               Unit{"s", "s", 1},
                               Unit{"N", "N", 1},
                               Unit{"kN", "N", 1000},
                               Unit{"N s", "N s", 1}};

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
  std::vector<std::string> names;
  for (const NamedColumn& column : columns) names.push_back(column.name);
  const NamedColumn& column = columns[in.choice("demand", names)];
  state.quantity.column = column.name;
  if (in.has("above") == in.has("below")) {
    in.note("above", ": must be given, or below, not both");
    return;
  }
  const bool above = in.has("above");
  state.kind = above ? LimitState::Kind::kAbove : LimitState::Kind::kBelow;
  const double limit = in.number(above ? "above" : "below", Range::any());
  double in_si = 1;
  std::string unit;
  std::vector<std::string> units;
  std::vector<double> factors;
  for (const Unit& each : kUnits)
    if (column.units == each.si) {
      units.push_back(each.name);
      factors.push_back(each.in_si);
    }
  if (units.empty()) {
    if (in.has("unit")) in.note("unit", ": " + column.name + " is a pure number");
  } else {
    const std::size_t chosen = in.choice("unit", units);
    in_si = factors[chosen];
    unit = " " + units[chosen];
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
      levels.push_back(index_of(states, name));
    } catch (const Error& error) {
      in.note("performance", std::string(": ") + error.what());
    }
  }
  return levels;
}

std::size_t index_of(const std::vector<LimitState>& states, const std::string& name) {
  std::vector<std::string> names;
  for (const LimitState& state : states) names.push_back(state.name);
  const auto found = std::ranges::find(names, name);
  require(found != names.end(), "no limit state '" + name + "'" + config::suggestion(name, names));
  return static_cast<std::size_t>(found - names.begin());
}

}  // namespace gurney::study
