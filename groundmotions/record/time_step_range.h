#pragma once

namespace gurney::groundmotions {

/// Time steps that a record may have [s]: 1 Hz to 100 kHz. Instruments have 50 to 1000 Hz.
inline constexpr double kShortestTimeStep = 1e-5, kLongestTimeStep = 1;
inline bool is_time_step(double step) {
  return step >= kShortestTimeStep && step <= kLongestTimeStep;
}

}  // namespace gurney::groundmotions
