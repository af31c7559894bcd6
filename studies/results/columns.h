#pragma once

#include <cmath>
#include <span>

#include "engine/response.h"

/// The numbers of a Response by name, unit and meaning. Results file, summary and JSON go through
/// these tables, so that a quantity has one name everywhere.
namespace gurney {

template <class Row>
struct Column {
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

std::span<const Column<Demands>> demand_columns();
std::span<const Column<WheelDemands>> wheel_demand_columns();
std::span<const Column<PointDemands>> point_demand_columns();
std::span<const Column<Quality>> quality_columns();
std::span<const Column<EnergyAccount>> energy_columns();
std::span<const Column<Impact>> impact_columns();  ///< without the names
std::span<const Column<ZoneOutcome>> zone_columns();
std::span<const Column<TetherOutcome>> tether_columns();

/// One number for each sample of a history.
std::span<const Column<Sample>> sample_columns();
std::span<const Column<WheelSample>> wheel_sample_columns();

}  // namespace gurney
