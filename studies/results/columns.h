#pragma once

#include <span>
#include <type_traits>
#include <variant>

#include "engine/response/demand_columns.h"
#include "engine/response/response.h"
#include "engine/response/settled.h"

/// The numbers of a Response by name, unit and meaning. Results file, summary and JSON go through
/// these tables, so that a quantity has one name everywhere.
namespace gurney::study {

using gurney::demand_columns;
using gurney::judged_point_columns;
using gurney::point_demand_columns;
using gurney::TableColumn;
using gurney::wheel_demand_columns;

/// Hands the members of a row that have a column to an archive (studies/run/archive.h), in
/// the order of the columns.
template <class Archive, class Row>
void visit_members(Archive& archive, Row& row, std::span<const TableColumn<Row>> columns) {
  for (const TableColumn<Row>& column : columns)
    std::visit(
        [&](auto of) {
          if constexpr (std::is_member_object_pointer_v<decltype(of)>) archive(row.*of);
        },
        column.source);
}

std::span<const TableColumn<Quality>> quality_columns();
std::span<const TableColumn<EnergyAccount>> energy_columns();
std::span<const TableColumn<Predictability>> predictability_columns();  ///< without the verdict
std::span<const TableColumn<SettledDemand>> settled_columns();          ///< without the names
std::span<const TableColumn<Impact>> impact_columns();                  ///< without the names
std::span<const TableColumn<ZoneOutcome>> zone_columns();
std::span<const TableColumn<TetherOutcome>> tether_columns();

/// One number for each sample of a history.
std::span<const TableColumn<Sample>> sample_columns();
std::span<const TableColumn<WheelSample>> wheel_sample_columns();

}  // namespace gurney::study
