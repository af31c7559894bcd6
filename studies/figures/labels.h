#pragma once

#include <string>

#include "studies/units/unit_system.h"

namespace gurney::figures {

/// What axes call a column of the results: "Peak displacement" of `peak_displacement`, "Tilt" of
/// `tilt`, "Peak floor acceleration" of `pfa`.
std::string label_of(const std::string& column);

/// "m/s²"
std::string unit_label(const study::ReportUnit& unit);

/// A name with its unit: "Peak displacement (m)", "Impacts".
std::string with_unit(const std::string& label, const study::ReportUnit& unit);

}  // namespace gurney::figures
