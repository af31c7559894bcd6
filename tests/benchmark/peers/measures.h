#pragma once

#include <array>
#include <string>
#include <vector>

#include "tests/peers/cross_check.h"

namespace gurney::benchmark {

/// Peak displacement [m], tilt [rad] and absolute horizontal acceleration of the base [m/s2], from
/// samples. The acceleration is the second difference of the absolute displacement over one
/// sampling interval: the mean with triangular weights over two, which a jump of the velocity at an
/// impact leaves finite.
///
/// @param euler_step  of an engine that adds h v(t + h) to positions [s]: positions are then those
///                    of h / 2 later, and the floor's are summed in the same way; 0: exact
using Peaks = std::array<double, 3>;
inline constexpr std::array<const char*, 3> kPeakNames = {"displacement", "tilt", "acceleration"};

Peaks peaks_of(const peers::Path& path, const peers::CrossCheck& check, double euler_step);

/// |a - b| / b, b at least what counts as rest: 1 mm, 0.1 degrees, 0.01 m/s2.
std::array<double, 3> relative_errors(const Peaks& a, const Peaks& b);

/// Until when two paths are within 5 % of the second one's peaks of displacement and tilt [s].
double agreement(const peers::Path& a, const peers::Path& b, double sampling);

double median(std::vector<double> values);

}  // namespace gurney::benchmark
