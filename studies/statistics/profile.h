#pragma once

#include <Eigen/Core>
#include <functional>

#include "studies/statistics/special.h"

/// Profile likelihoods of two parameters.
namespace gurney::statistics {

/// Largest value of a function of two parameters on the line `point` + c `along`.
/// @param function  value, gradient and curvature at a point
/// @param start     the c from which it is searched
double largest_on_line(const std::function<Quadratic<2>(const Eigen::Vector2d&)>& function,
                       const Eigen::Vector2d& point, const Eigen::Vector2d& along, double start);

/// The distance from 0, in the direction of `step`, at which `drop` rises through `limit`; infinite if it
/// has not within 512 steps.
double crossing(const std::function<double(double)>& drop, double limit, double step);

}  // namespace gurney::statistics
