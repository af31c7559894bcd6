#pragma once

#include <string>

#include "studies/calibration/fit/calibration.h"

namespace gurney::figures {

/// Resistance against load with fitted lines and bands of 95 %, and the phases of one pull.
std::string calibration_figure(const calibration::Calibration& calibration);

}  // namespace gurney::figures
