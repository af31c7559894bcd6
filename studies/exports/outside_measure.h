#pragma once

#include <optional>
#include <string>

#include "studies/analysis/study_data.h"

namespace gurney::study {

/// What another format calls an intensity measure.
struct OutsideMeasure {
  std::string name;
  std::string unit;
  double unit_in_si = 1;
};

/// Name and unit in the vocabulary of the Damage and Loss Model Library (DLML 3.1), which pelicun
/// reads: peak ground and floor acceleration and velocity, and Sa with 5 % damping.
std::optional<OutsideMeasure> dlml_measure(const std::string& measure);

/// Name and unit in NRML: PGA and SA(T) with 5 % damping in g, PGV in cm/s. NRML has no names for
/// what a floor does.
std::optional<OutsideMeasure> nrml_measure(const std::string& measure);

using NameMeasure = std::optional<OutsideMeasure> (*)(const std::string&);

/// @param measure  of the study's measures
/// @throws Error where the format has no name for it, with those of the study that have one
OutsideMeasure outside_measure(const StudyData& data, const std::string& measure,
                               const std::string& format, NameMeasure name);

}  // namespace gurney::study
