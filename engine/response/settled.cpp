#include "engine/response/settled.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <string>

#include "engine/base/error.h"
#include "engine/response/demand_columns.h"
#include "engine/scene/perturbed.h"

namespace gurney {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

template <class Row>
void append(std::vector<DemandNumber>& numbers, DemandNumber::Of of, std::size_t part,
            std::span<const TableColumn<Row>> columns, const Row& row) {
  for (const TableColumn<Row>& column : columns) {
    const double value = column.value(row);
    numbers.push_back(
        {of, part, column.name, column.units,
         column.is_missing(value) ? std::numeric_limits<double>::quiet_NaN() : value});
  }
}

/// Whether neither run has anything of it: no lift-off, no overturning.
bool is_nothing(const SettledDemand& demand) {
  const auto nothing = [](double value) { return std::isnan(value) || value == 0; };
  return nothing(demand.number.value) && nothing(demand.at_half_step);
}

std::vector<SettledDemand> changes_of(const Demands& run, const Predictability& found) {
  std::vector<SettledDemand> all;
  if (!found.twin || !found.half_step) return all;
  const std::vector<DemandNumber> half = numbers_of(*found.half_step),
                                  twin = numbers_of(*found.twin);
  for (const DemandNumber& number : numbers_of(run)) {
    const DemandNumber &at_half = half[all.size()], &of_twin = twin[all.size()];
    all.push_back({number, at_half.value, of_twin.value, change_between(number, at_half),
                   change_between(number, of_twin), 0});
  }
  return all;
}

double upper_quartile(const std::vector<SettledDemand>& all) {
  std::vector<double> changes;
  for (const SettledDemand& each : all)
    if (!is_nothing(each)) changes.push_back(std::abs(each.step_change));
  if (changes.empty()) return 0;
  const auto quartile = changes.begin() + static_cast<std::ptrdiff_t>(3 * changes.size() / 4);
  std::ranges::nth_element(changes, quartile);
  return *quartile;
}

}  // namespace

bool DemandNumber::counts_events() const {
  return units == std::string_view("1") && name != std::string_view("most_wheels_lifted");
}

bool DemandNumber::is_of_overturning() const {
  return std::string_view(name).ends_with("_of_overturning");
}

std::vector<DemandNumber> numbers_of(const Demands& demands) {
  using Of = DemandNumber::Of;
  std::vector<DemandNumber> numbers;
  append(numbers, Of::kItem, 0, demand_columns(), demands);
  for (std::size_t i = 0; i < demands.wheels.size(); ++i)
    append(numbers, Of::kWheel, i, wheel_demand_columns(), demands.wheels[i]);
  for (std::size_t i = 0; i < demands.points.size(); ++i)
    append(numbers, Of::kPoint, i, judged_point_columns(), demands.points[i]);
  return numbers;
}

double size_of_interest(std::string_view units) {
  // Lengths and angles that count as rest; 1 cm/s, 0.01 g, the weight of 1 kg, the impulse of 100 kg
  // at 1 cm/s, 100 steps of 4 ms: assumptions.
  static const std::map<std::string_view, double> kSizes = {
      {"m", Predictability::kLeastDisplacement},
      {"rad", Predictability::kLeastTilt},
      {"m/s", 0.01},
      {"m/s2", 0.1},
      {"N", 10},
      {"N s", 1},
      {"s", 0.4},
      {"1", 1}};
  const auto found = kSizes.find(units);
  require(found != kSizes.end(), "no size of interest is stated for " + std::string(units));
  return found->second;
}

double relative_change(const char* name, const char* units, double from, double to) {
  if (std::isnan(from) || std::isnan(to)) return std::isnan(from) && std::isnan(to) ? 0 : kInfinite;
  if (std::string_view(name).starts_with("direction_of_"))
    return std::remainder(to - from, 2 * std::numbers::pi);
  return (to - from) / std::max({std::abs(from), std::abs(to), size_of_interest(units)});
}

double SettledDemand::within() const {
  if (!predictable()) return kInfinite;
  const double change = std::max(std::abs(step_change), least_change);
  for (const double fraction : kFractions)
    if (kMargin * change <= fraction) return fraction;
  return kInfinite;
}

bool SettledDemand::predictable() const {
  return std::abs(twin_change) < Predictability::kSensitive * kPerturbation;
}

double change_of_a_quarter(const Demands& run, const Predictability& found) {
  return upper_quartile(changes_of(run, found));
}

std::vector<SettledDemand> settled_demands(const ItemResponse& item) {
  if (!item.predictability) return {};
  std::vector<SettledDemand> all = changes_of(item.demands, *item.predictability);
  // An impact that did not happen beside such a neighbour may happen.
  const double beside = item.predictability->change_of_neighbours,
               least = SettledDemand::kShareOfOthers * std::max(upper_quartile(all), beside);
  for (SettledDemand& each : all) {
    if (each.number.is_of_overturning()) continue;
    if (is_nothing(each))
      each.least_change = SettledDemand::kShareOfOthers * beside;
    else
      each.least_change = each.number.counts_events() ? kInfinite : least;
  }
  return all;
}

}  // namespace gurney
