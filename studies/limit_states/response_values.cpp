#include "studies/limit_states/response_values.h"

#include <span>
#include <stdexcept>

#include "studies/results/columns.h"
#include "studies/results/names.h"

namespace gurney::study {
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
      if (quantity.item.empty() || quantity.item == names[i])
        append_of_item(quantity, scene.items[i].model, response.items[i].demands, values);
    return values;
  };
}

}  // namespace gurney::study
