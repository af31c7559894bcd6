#pragma once

#include <string>
#include <vector>

#include "groundmotions/record/record.h"

namespace gurney::groundmotions {

/// Doubts about the amplitudes of a record, one sentence each; empty if nothing does:
///
/// - a component that is all zero;
/// - a peak below 0.001 g or above 3 g: mostly a wrong unit, or velocities taken as accelerations.
///   The largest recorded peaks known to us are near 3 g;
/// - peaks of two components that differ by more than a factor of 100;
/// - a mean above a tenth of the peak, over 100 samples or more: a constant offset that was not
/// removed. Twice integrated it
///   outweighs every earthquake;
/// - two components that are the same, sample by sample.
///
/// The end of the motion is judged by residual().
std::vector<std::string> implausible(const Record& record);

}  // namespace gurney::groundmotions
