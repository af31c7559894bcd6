#pragma once

#include <string>
#include <vector>

#include "studies/units/unit_system.h"

namespace gurney::figures {

/// Title of an axis for a column of the results: "Peak displacement" of `peak_displacement`, "Tilt" of
/// `tilt`, "Peak floor acceleration" of `pfa`.
std::string label_of(const std::string& column);

/// Inputs that were drawn, which have the same values: "front left: tread normal damping and 3 equal
/// to it" of `front left/tread.normal_damping_n_s_per_m` and three more.
std::string input_label(const std::vector<std::string>& names);

/// "m/s²"
std::string unit_label(const study::ReportUnit& unit);

/// A name with its unit: "Peak displacement (m)", "Impacts".
std::string with_unit(const std::string& label, const study::ReportUnit& unit);

}  // namespace gurney::figures
