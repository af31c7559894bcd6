#pragma once

#include <Eigen/Core>
#include <functional>

namespace gurney::groundmotions {

/// The lowest value of a function of the period, and where it is.
struct LowestRatio {
  double period = 0;  ///< [s]
  double ratio = 0;
};

/// Finds the lowest value between given periods too. Intervals are halved until none can go below
/// the lowest value found by more than `tolerance` (relative), if the function is nowhere twice as
/// steep over ln T as beside the steepest interval of its neighbourhood.
/// @param periods    growing, > 0, at least 2 [s]
/// @param ratios     of the periods, > 0
/// @param ratios_at  the function, at periods in any order
LowestRatio lowest_ratio(const Eigen::VectorXd& periods, const Eigen::VectorXd& ratios,
                         const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& ratios_at,
                         double tolerance);

}  // namespace gurney::groundmotions
