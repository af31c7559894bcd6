#pragma once

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
  double missing = 0;  ///< not 0: this value means "there is none"
};

std::span<const Column<Demands>> demand_columns();
std::span<const Column<WheelDemands>> wheel_demand_columns();
std::span<const Column<PointDemands>> point_demand_columns();
std::span<const Column<Quality>> quality_columns();
std::span<const Column<EnergyAccount>> energy_columns();

/// One number for each sample of a history.
std::span<const Column<Sample>> sample_columns();
std::span<const Column<WheelSample>> wheel_sample_columns();

}  // namespace gurney
