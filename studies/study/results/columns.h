#pragma once

#include <cmath>
#include <functional>
#include <span>
#include <type_traits>
#include <variant>

#include "engine/response/response.h"

/// The numbers of a Response by name, unit and meaning. Results file, summary and JSON go through
/// these tables, so that a quantity has one name everywhere.
namespace gurney::study {

template <class Row>
struct TableColumn {
  /// A member of the row, or a number that follows from it.
  using Source =
      std::variant<double Row::*, int Row::*, long Row::*, bool Row::*, double (*)(const Row&)>;

  const char* name;
  const char* units;  ///< "1" for a pure number
  const char* meaning;
  Source source;
  double missing = 0;  ///< not 0: this value (or, if NaN, no number) means "there is none"

  double value(const Row& row) const {
    return std::visit([&](auto of) { return static_cast<double>(std::invoke(of, row)); }, source);
  }
  bool whole() const { return source.index() >= 1 && source.index() <= 3; }  ///< a count
  bool is_missing(double number) const {
    return std::isnan(missing) ? std::isnan(number) : missing != 0 && number == missing;
  }
};

/// Hands the members of a row that have a column to an archive (studies/study/run/archive.h), in
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

std::span<const TableColumn<Demands>> demand_columns();
std::span<const TableColumn<WheelDemands>> wheel_demand_columns();
std::span<const TableColumn<PointDemands>> point_demand_columns();
std::span<const TableColumn<Quality>> quality_columns();
std::span<const TableColumn<EnergyAccount>> energy_columns();
std::span<const TableColumn<Predictability>> predictability_columns();  ///< without the verdict
std::span<const TableColumn<Impact>> impact_columns();                  ///< without the names
std::span<const TableColumn<ZoneOutcome>> zone_columns();
std::span<const TableColumn<TetherOutcome>> tether_columns();

/// One number for each sample of a history.
std::span<const TableColumn<Sample>> sample_columns();
std::span<const TableColumn<WheelSample>> wheel_sample_columns();

}  // namespace gurney::study
