#pragma once

#include "tests/peers/cross_check.h"

namespace gurney::peers {

/// Of the engine itself.
Path our_path(const CrossCheck& check, double time_step);

double peak(const Path& path);  ///< displacement from the start [m]

/// Largest, at equal times.
double distance(const Path& a, const Path& b);

/// The shipped trolley with casters at 10, 100, 200 and 300 degrees, without scrub and friction of
/// bearings and with mu_s = mu_k, under 12 s of synthetic three-component motion.
CrossCheck trolley_check(unsigned record, double peak_g);

/// Casters 0 and 1 can neither turn nor roll.
CrossCheck half_locked_check(unsigned record, double peak_g);

}  // namespace gurney::peers
