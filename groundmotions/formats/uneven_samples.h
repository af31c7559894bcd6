#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace gurney::groundmotions {

inline constexpr double kLongestGap = 2;  ///< between digitised samples; an assumption [s]

/// The time step that unevenly spaced samples are brought to unless the user states one: films of
/// old accelerographs were digitised at uneven times, and their programs took 0.005 s too [s].
inline constexpr double kEvenTimeStep = 0.005;

/// Smallest and largest difference of times that follow each other [s].
struct Spacing {
  double smallest = 0;  ///< negative if times decrease
  double largest = 0;

  /// Whether all times lie on a grid with equal steps, printed times being rounded by at most half
  /// of `rounding`.
  bool even(double rounding) const { return smallest > 0 && largest - smallest <= 2 * rounding; }
};

/// @param times  at least 2 [s]
Spacing spacing_of(const std::vector<double>& times);

/// Values on the grid times[0] + i time_step, i = 0, 1, ... up to the last time, by straight lines
/// between the samples around. Of samples at one time the last counts from that time on.
/// @param times      at least 2, not decreasing, the last above the first [s]
/// @param values     as many, in any unit
/// @param time_step  > 0 and not longer than the whole [s]
/// @throws Error if any of these does not hold.
Eigen::VectorXd evenly_spaced(const std::vector<double>& times, const std::vector<double>& values,
                              double time_step);

/// Warning that a component must have of samples that were brought to an even time step.
std::string uneven_warning(const std::vector<double>& times, double time_step);

}  // namespace gurney::groundmotions
