#pragma once

#include <string>
#include <vector>

#include "studies/calibration/fit/calibration.h"
#include "studies/calibration/fit/caster_file.h"

namespace gurney::report {

/// What `gurney calibrate` prints.
std::string calibration_text(const calibration::Calibration& calibration);

/// The same as one JSON object, in SI units, of which `gurney report` makes a page.
/// @param without  why there is no caster file of a caster
std::string calibration_json(const calibration::Calibration& calibration,
                             const std::vector<calibration::CasterFile>& casters = {},
                             const std::vector<std::string>& without = {});

}  // namespace gurney::report
