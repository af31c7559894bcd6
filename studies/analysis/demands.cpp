#include "studies/analysis/demands.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <span>

#include "engine/base/error.h"
#include "engine/config/nearest_name.h"
#include "studies/results/columns.h"

namespace gurney::study {
namespace {

/// Item, or item and point, of the first run of a configuration.
std::vector<std::pair<std::string, std::string>> places_in(const StudyData& data,
                                                           std::size_t configuration,
                                                           const std::string& table) {
  const std::vector<std::size_t>& runs = data.runs_of(configuration);
  if (runs.empty() || !data.file().has(table)) return {};
  const auto [first, last] = data.file().rows_of_runs(table)[runs.front()];
  const std::vector<std::string> items = data.file().strings(table + "/item");
  std::vector<std::string> points(items.size());
  if (table == "points") points = data.file().strings("points/point");
  std::vector<std::pair<std::string, std::string>> places;
  for (std::size_t row = first; row < last; ++row) places.emplace_back(items[row], points[row]);
  return places;
}

template <class Row>
std::string units_in(std::span<const TableColumn<Row>> columns, const std::string& name) {
  for (const TableColumn<Row>& column : columns)
    if (column.name == name) return column.units;
  return "1";
}

std::vector<NamedDemand> all_demands(const StudyData& data, std::size_t configuration) {
  std::vector<NamedDemand> all;
  for (const auto& [item, point] : places_in(data, configuration, "items"))
    for (const TableColumn<Demands>& column : demand_columns())
      if (data.file().has_column(std::string("items/") + column.name))
        all.push_back({item + ": " + column.name,
                       column.units,
                       {Quantity::Of::kItem, column.name, item, ""}});
  for (const auto& [item, point] : places_in(data, configuration, "points"))
    for (const TableColumn<PointDemands>& column : point_demand_columns())
      if (data.file().has_column(std::string("points/") + column.name))
        all.push_back({item + "/" + point + ": " + column.name,
                       column.units,
                       {Quantity::Of::kPoint, column.name, item, point}});
  return all;
}

bool is_size(const NamedDemand& demand) {
  const std::string& column = demand.quantity.column;
  if (demand.quantity.of == Quantity::Of::kPoint)
    return column.ends_with("_acceleration") && !column.starts_with("numerical");
  return !column.ends_with("_x") && !column.ends_with("_y") && !column.starts_with("time_of") &&
         !column.starts_with("direction_of");
}

/// A column whose sign is a direction.
bool is_signed(const NamedDemand& demand) {
  return demand.quantity.of == Quantity::Of::kItem && demand.quantity.column == "residual_yaw";
}

std::string column_of(const NamedDemand& demand) {
  return demand.absolute ? "|" + demand.quantity.column + "|" : demand.quantity.column;
}

NamedDemand size_of(NamedDemand demand) {
  demand.absolute = true;
  demand.name = demand.quantity.item + ": " + column_of(demand);
  return demand;
}

}  // namespace

std::vector<NamedDemand> demands_of(const StudyData& data, std::size_t configuration) {
  std::vector<NamedDemand> all = all_demands(data, configuration);
  std::erase_if(all, [](const NamedDemand& each) { return !is_size(each); });
  for (NamedDemand& each : all)
    if (is_signed(each)) each = size_of(each);
  return all;
}

std::vector<NamedDemand> demands_named(const StudyData& data, std::size_t configuration,
                                       const std::vector<std::string>& names) {
  std::vector<NamedDemand> all = all_demands(data, configuration);
  for (std::size_t i = 0, end = all.size(); i < end; ++i)
    if (is_signed(all[i])) all.push_back(size_of(all[i]));
  std::vector<NamedDemand> result;
  for (const std::string& name : names) {
    const std::size_t before = result.size();
    for (const NamedDemand& each : all)
      if (each.name == name || (each.quantity.of == Quantity::Of::kItem && column_of(each) == name))
        result.push_back(each);
    if (result.size() > before) continue;
    const std::string& of = data.configurations()[configuration];
    require(!all.empty(), fmt::format("{}: all runs{} failed: none has demands", data.file().path(),
                                      of.empty() ? "" : " of " + of));
    std::vector<std::string> known;
    for (const TableColumn<Demands>& column : demand_columns()) {
      known.push_back(column.name);
      if (name == column.name) data.file().numbers("items/" + name);  // or it is not in this file
    }
    for (const NamedDemand& each : all) known.push_back(each.name);
    throw Error(fmt::format("{}: no demand '{}'{}", data.file().path(), name,
                            config::suggestion(name, known)));
  }
  return result;
}

std::string units_of(const Quantity& quantity) {
  switch (quantity.of) {
    case Quantity::Of::kItem:
      return units_in(demand_columns(), quantity.column);
    case Quantity::Of::kPoint:
      return units_in(point_demand_columns(), quantity.column);
    case Quantity::Of::kZone:
      return units_in(zone_columns(), quantity.column);
    case Quantity::Of::kTether:
      break;
  }
  return units_in(tether_columns(), quantity.column);
}

std::vector<double> values_of_runs(const StudyData& data, const NamedDemand& demand,
                                   const std::vector<std::size_t>& runs) {
  FileValues values(data.file());
  std::vector<double> result;
  for (const std::size_t run : runs) {
    double largest = std::numeric_limits<double>::quiet_NaN();
    for (const double signed_value : values(run, demand.quantity)) {
      const double value = demand.absolute ? std::abs(signed_value) : signed_value;
      if (!std::isnan(value) && !(value <= largest)) largest = value;
    }
    result.push_back(largest);
  }
  return result;
}

}  // namespace gurney::study
