#pragma once

#include <cmath>
#include <functional>
#include <span>
#include <variant>

#include "engine/response/demands.h"

/// The demands by name, unit and meaning. Whatever judges, writes or reads them goes through these
/// tables, so that a quantity has one name everywhere.
namespace gurney {

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

std::span<const TableColumn<Demands>> demand_columns();
std::span<const TableColumn<WheelDemands>> wheel_demand_columns();
std::span<const TableColumn<PointDemands>> point_demand_columns();
/// Without numerical accelerations, which are none.
std::span<const TableColumn<PointDemands>> judged_point_columns();

}  // namespace gurney
