#pragma once

#include <string>

#include "studies/calibration/fit/calibration.h"

namespace gurney::report {

/// What `gurney calibrate` prints.
std::string calibration_text(const calibration::Calibration& calibration);

/// The same as one JSON object, in SI units.
std::string calibration_json(const calibration::Calibration& calibration);

}  // namespace gurney::report
