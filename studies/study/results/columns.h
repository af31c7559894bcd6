#pragma once

#include <cmath>
#include <span>

#include "engine/response/response.h"

/// The numbers of a Response by name, unit and meaning. Results file, summary and JSON go through
/// these tables, so that a quantity has one name everywhere.
namespace gurney::study {

template <class Row>
struct TableColumn {
  const char* name;
  const char* units;  ///< "1" for a pure number
  const char* meaning;
  double (*value)(const Row&);
  bool whole = false;  ///< a count
  double missing = 0;  ///< not 0: this value (or, if NaN, no number) means "there is none"

  bool is_missing(double number) const {
    return std::isnan(missing) ? std::isnan(number) : missing != 0 && number == missing;
  }
};

std::span<const TableColumn<Demands>> demand_columns();
std::span<const TableColumn<WheelDemands>> wheel_demand_columns();
std::span<const TableColumn<PointDemands>> point_demand_columns();
std::span<const TableColumn<Quality>> quality_columns();
std::span<const TableColumn<EnergyAccount>> energy_columns();
std::span<const TableColumn<Impact>> impact_columns();  ///< without the names
std::span<const TableColumn<ZoneOutcome>> zone_columns();
std::span<const TableColumn<TetherOutcome>> tether_columns();

/// One number for each sample of a history.
std::span<const TableColumn<Sample>> sample_columns();
std::span<const TableColumn<WheelSample>> wheel_sample_columns();

}  // namespace gurney::study
