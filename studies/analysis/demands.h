#pragma once

#include <string>
#include <vector>

#include "studies/analysis/study_data.h"

namespace gurney::study {

/// SI; of events and counts "1".
std::string units_of(const Quantity& quantity);

/// A demand that study files keep for each run.
struct NamedDemand {
  std::string name;  ///< "icu_ventilator: peak_displacement"
  std::string units;
  Quantity quantity;
  bool absolute = false;  ///< the size of a signed column; named "icu_ventilator: |residual_yaw|"
};

/// The sizes of all items of a configuration, and the accelerations of their marked points. Of
/// signed columns the absolute value. Left out are times and directions, x and y of vectors, and
/// what is no demand but numerical.
std::vector<NamedDemand> demands_of(const StudyData& data, std::size_t configuration);

/// The demands with one of the names: of an item's column ("peak_displacement", x and y too), or
/// with item and point before it as demands_of() has them.
/// @throws Error with the nearest name
std::vector<NamedDemand> demands_named(const StudyData& data, std::size_t configuration,
                                       const std::vector<std::string>& names);

/// For each run the largest of the demand's values; NaN: it has none.
std::vector<double> values_of_runs(const StudyData& data, const NamedDemand& demand,
                                   const std::vector<std::size_t>& runs);

}  // namespace gurney::study
