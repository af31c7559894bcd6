#pragma once

#include <vector>

namespace gurney::benchmark {

/// What steps of one length cost and miss: the shipped trolley for 20 s under synthetic motions of
/// 0.4 g, from seed 1 on, all of them.
struct FreeTrolleyPoint {
  double step;          ///< [s]
  double speed;         ///< simulated over CPU time, the lesser of three runs
  double median_error;  ///< of the peak displacement, relative to that at 0.25 ms
  double larger_error;  ///< in nine of ten motions it is less
};
std::vector<FreeTrolleyPoint> free_trolley(const std::vector<double>& steps, int motions);

}  // namespace gurney::benchmark
