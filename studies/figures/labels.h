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

/// Span of the axis of a history whose values differ less: nobody asks for so small differences, and
/// rounding is a flat line. By SI unit [that unit]; 0: not known of this unit.
double least_span(const std::string& si);

/// A name with its unit: "Peak displacement (m)", "Impacts".
std::string with_unit(const std::string& label, const study::ReportUnit& unit);

}  // namespace gurney::figures
