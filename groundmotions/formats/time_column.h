#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "groundmotions/formats/source_file.h"

namespace gurney::groundmotions {

inline constexpr double kTimeTolerance = 0.01;  ///< of a time from the even grid, in steps

/// The step of evenly spaced times, (last - first) / (count - 1), to twelve digits so that 0.005 is
/// 0.005 [s]. An error unless it is in (0, 1] and every time is within kTimeTolerance of the even
/// grid; the message names the largest deviation.
/// @param times     at least 2
/// @param lines     of the times in the file, from 1
/// @param rounding  of the times besides, where they are printed with few digits [s]
double even_step(const std::vector<double>& times, const std::vector<std::size_t>& lines,
                 FileErrors& errors, double rounding = 0);

/// Why numbers cannot be samples: at least 20 that rise by one step of at most 0.5, or 100 by any,
/// are times or indices. Empty if they are not.
std::string axis_error(const std::vector<double>& values);

/// A warning for a first time that is not 0; empty if it is.
std::string late_start(double first_time, double step);

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
