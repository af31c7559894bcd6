#pragma once

#include <string>
#include <vector>

#include "groundmotions/formats/file_errors.h"

namespace gurney::groundmotions {

inline constexpr double kTimeTolerance = 0.01;  ///< of a time from the even grid, in steps

/// The step of evenly spaced times, (last - first) / (count - 1), to twelve digits so that 0.005 is
/// 0.005 [s]. An error unless it is in (0, 1] and every time is within kTimeTolerance of the even
/// grid; the message names the largest deviation.
/// @param times  at least 2
/// @param lines  of the times in the file, from 1
double even_step(const std::vector<double>& times, const std::vector<std::size_t>& lines,
                 FileErrors& errors);

/// Why numbers cannot be samples: at least 20 that rise by one step of at most 0.5, or 100 by any,
/// are times or indices. Empty if they are not.
std::string axis_error(const std::vector<double>& values);

/// A warning for a first time that is not 0; empty if it is.
std::string late_start(double first_time, double step);

}  // namespace gurney::groundmotions
