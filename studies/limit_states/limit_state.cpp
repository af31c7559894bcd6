#include "studies/limit_states/limit_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <stdexcept>
#include <string_view>

#include "engine/base/error.h"
#include "engine/base/names.h"
#include "engine/config/nearest_name.h"
#include "studies/results/columns.h"
#include "studies/results/names.h"

namespace gurney::study {
namespace {

/// Rounding of a limit that is converted to SI: two roundings, of the factor and of the product,
/// are 2^-52 each; 4 times that for decimal fractions that are not exact.
constexpr double kRounding = 1e-15;

constexpr std::array<std::string_view, 9> kOfPartsAndContents = {
    "peak_slide", "time_of_fall",   "time_of_toppling", "peak_travel",       "residual_travel",
    "peak_swing", "residual_swing", "time_of_release",  "largest_stop_speed"};

}  // namespace

bool counts_of(const Quantity& quantity, const std::string& item) {
  if (!quantity.item.empty()) return quantity.item == item;
  return quantity.of != Quantity::Of::kItem || item.find('/') == std::string::npos ||
         std::ranges::find(kOfPartsAndContents, quantity.column) != kOfPartsAndContents.end();
}

bool exceeded(const std::vector<LimitState>& states, std::size_t index, const Values& values) {
  const LimitState& state = states[index];
  const auto part = [&](std::size_t i) { return exceeded(states, i, values); };
  const auto enough = [&](const auto& list, auto passes) {
    return std::ranges::count_if(list, passes) >= state.at_least;
  };
  switch (state.kind) {
    case LimitState::Kind::kAny:
      return enough(state.parts, part);
    case LimitState::Kind::kAll:
      return std::ranges::all_of(state.parts, part);
    case LimitState::Kind::kAbove:
      return enough(values(state.quantity), [&](double value) { return value > state.limit; });
    case LimitState::Kind::kBelow:
      return enough(values(state.quantity), [&](double value) { return value < state.limit; });
  }
  return false;
}

bool same_state(const std::vector<LimitState>& a, std::size_t i, const std::vector<LimitState>& b,
                std::size_t j) {
  if (a[i].kind != b[j].kind || a[i].quantity != b[j].quantity || a[i].at_least != b[j].at_least ||
      a[i].parts.size() != b[j].parts.size() ||
      std::abs(a[i].limit - b[j].limit) > kRounding * std::abs(a[i].limit))
    return false;
  for (std::size_t k = 0; k < a[i].parts.size(); ++k)
    if (!same_state(a, a[i].parts[k], b, b[j].parts[k])) return false;
  return true;
}

std::vector<LimitState> default_limit_states() {
  const auto above = [](const char* name, const char* column, double limit, const char* words,
                        const char* origin) {
    return LimitState{
        name, LimitState::Kind::kAbove, {Quantity::Of::kItem, column, "", ""}, limit, words, origin,
        {}};
  };
  return {above("moved", "residual_displacement", 0.02, "residual_displacement > 0.02 m",
                "damage state of Costa et al. as cited by Shang et al."),
          above("rolled", "peak_displacement", 0.3, "peak_displacement > 0.3 m",
                "assumption, 0.2 to 1 m: reach of tubes and cables"),
          above("hit", "largest_approach_speed", 0.4, "largest_approach_speed > 0.4 m/s",
                "assumption, 0.2 to 0.8 m/s: handling speeds of the threshold test of IEC 60601-1"),
          above("overturned", "time_of_overturning", -0.5, "overturned", "")};
}

namespace {

void must_be(const std::string& kind, const std::string& name,
             const std::vector<std::string>& names, const std::string& owner) {
  require(std::ranges::find(names, name) != names.end(),
          owner + " has no " + kind + " '" + name + "'" + config::suggestion(name, names));
}

}  // namespace

Places places_of(const Scene& scene) {
  Places places{item_names(scene), names_of(scene.zones), names_of(scene.tethers), {}};
  for (std::size_t i = 0; i < scene.items.size(); ++i) {
    for (const std::string& name : point_names(scene.items[i].model))
      places.points.emplace_back(places.items[i], name);
    if (const auto& on = scene.items[i].on; on && on->kind == Support::Kind::kItem)
      places.on_items.push_back(places.items[i]);
  }
  return places;
}

void check_names(const LimitState& state, const Places& places, const std::string& owner) {
  const Quantity& quantity = state.quantity;
  if (!state.is_simple()) return;
  require(state.at_least <= static_cast<int>(places.items.size()),
          fmt::format("at_least = {}: must be at most {}, the items and contents of {}",
                      state.at_least, places.items.size(), owner));
  if (!quantity.item.empty()) must_be("item", quantity.item, places.items, owner);
  const bool on_item = std::ranges::find(places.on_items, quantity.item) != places.on_items.end();
  require(!on_item || quantity.column != "time_of_overturning",
          fmt::format("'{}' stands on another item, where it is not overturned but \"toppled\"",
                      quantity.item));
  if (quantity.of == Quantity::Of::kZone) must_be("zone", quantity.part, places.zones, owner);
  if (quantity.of == Quantity::Of::kTether) must_be("tether", quantity.part, places.tethers, owner);
  if (quantity.of != Quantity::Of::kPoint) return;
  std::vector<std::string> points;
  for (const auto& [item, point] : places.points)
    if (quantity.item.empty() || quantity.item == item) points.push_back(point);
  must_be("marked point", quantity.part, points, owner);
}

namespace {

template <class Row>
double value(std::span<const TableColumn<Row>> columns, const std::string& name, const Row& row) {
  for (const TableColumn<Row>& column : columns)
    if (name == column.name) return column.value(row);
  throw std::logic_error("no column " + name);
}

void append_of_item(const Quantity& quantity, const EquipmentModel& model, const Demands& demands,
                    std::vector<double>& values) {
  if (quantity.of == Quantity::Of::kItem) {
    values.push_back(value(demand_columns(), quantity.column, demands));
    return;
  }
  const std::vector<std::string> points = point_names(model);
  for (std::size_t i = 0; i < demands.points.size(); ++i)
    if (points[i] == quantity.part)
      values.push_back(value(point_demand_columns(), quantity.column, demands.points[i]));
}

template <class Outcome, class Named>
void append_of_part(const Quantity& quantity, const std::vector<Named>& named,
                    const std::vector<Outcome>& outcomes,
                    std::span<const TableColumn<Outcome>> columns, std::vector<double>& values) {
  for (std::size_t i = 0; i < outcomes.size(); ++i)
    if (named[i].name == quantity.part)
      values.push_back(value(columns, quantity.column, outcomes[i]));
}

}  // namespace

Values values_of(const Scene& scene, const Response& response) {
  return [&](const Quantity& quantity) {
    std::vector<double> values;
    if (quantity.of == Quantity::Of::kZone) {
      append_of_part(quantity, scene.zones, response.zones, zone_columns(), values);
      return values;
    }
    if (quantity.of == Quantity::Of::kTether) {
      append_of_part(quantity, scene.tethers, response.tethers, tether_columns(), values);
      return values;
    }
    const std::vector<std::string> names = item_names(scene);
    for (std::size_t i = 0; i < response.items.size(); ++i)
      if (counts_of(quantity, names[i]))
        append_of_item(quantity, scene.items[i].model, response.items[i].demands, values);
    return values;
  };
}

}  // namespace gurney::study
