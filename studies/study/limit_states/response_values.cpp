#include "studies/study/limit_states/response_values.h"

#include <algorithm>
#include <span>
#include <stdexcept>

#include "engine/base/error.h"
#include "engine/config/nearest_name.h"
#include "studies/study/results/columns.h"
#include "studies/study/results/names.h"

namespace gurney::study {
namespace {

template <class Row>
double value(std::span<const TableColumn<Row>> columns, const std::string& name, const Row& row) {
  for (const TableColumn<Row>& column : columns)
    if (name == column.name) return column.value(row);
  throw std::logic_error("no column " + name);
}

template <class Named>
std::vector<std::string> names_in(const std::vector<Named>& list) {
  std::vector<std::string> names;
  for (const Named& each : list) names.push_back(each.name);
  return names;
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

void must_be(const std::string& kind, const std::string& name,
             const std::vector<std::string>& names) {
  require(std::ranges::find(names, name) != names.end(),
          "the job has no " + kind + " '" + name + "'" + config::suggestion(name, names));
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
      if (quantity.item.empty() || quantity.item == names[i])
        append_of_item(quantity, scene.items[i].model, response.items[i].demands, values);
    return values;
  };
}

void check_names(const LimitState& state, const Scene& scene) {
  const Quantity& quantity = state.quantity;
  const bool simple =
      state.kind == LimitState::Kind::kAbove || state.kind == LimitState::Kind::kBelow;
  if (!simple) return;
  const std::vector<std::string> items = item_names(scene);
  if (!quantity.item.empty()) must_be("item", quantity.item, items);
  if (quantity.of == Quantity::Of::kZone) must_be("zone", quantity.part, names_in(scene.zones));
  if (quantity.of == Quantity::Of::kTether)
    must_be("tether", quantity.part, names_in(scene.tethers));
  if (quantity.of != Quantity::Of::kPoint) return;
  std::vector<std::string> points;
  for (std::size_t i = 0; i < items.size(); ++i)
    if (quantity.item.empty() || quantity.item == items[i])
      for (const std::string& name : point_names(scene.items[i].model)) points.push_back(name);
  must_be("marked point", quantity.part, points);
}

}  // namespace gurney::study
