#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "groundmotions/record/record.h"

namespace gurney::groundmotions {

using HeaderFacts = std::vector<std::pair<std::string, std::string>>;

/// Samples of f(t) from 0 s to the first sample at or behind `duration`.
/// @throws Error for more than 10 million samples or fewer than 4.
Eigen::VectorXd sampled(double time_step, double duration,
                        const std::function<double(double)>& function);

/// A component that says it is synthetic. A motion that does not end at rest gets a warning with
/// the velocity and the displacement that are left: more than 1e-6 of its peaks.
Component synthetic_component(Direction direction, double time_step, Eigen::VectorXd acceleration);

/// A record of one component, h1.
Record single_component(double time_step, Eigen::VectorXd acceleration);

/// Writes into every component what made it: that it is synthetic, the kind, its source, the facts.
void describe_synthetic(Record& record, const std::string& kind, const std::string& source,
                        const HeaderFacts& facts);

/// Velocity [m/s] and displacement [m] at the last sample, from rest at the first, by
/// processing/integrate.h.
Eigen::Vector2d end_state(double time_step, const Eigen::VectorXd& acceleration);

/// Takes c_1 s^2 + c_2 s^2 cos(pi t / T), s = sin(pi t / T), off an acceleration so that it ends in
/// the wanted state. Both shapes and their slopes vanish at the ends.
/// @param acceleration  at least 4 samples
void set_end_state(double time_step, Eigen::VectorXd& acceleration,
                   const Eigen::Vector2d& wanted = Eigen::Vector2d::Zero());

/// The acceleration, linear between samples, whose exact integrals from rest pass through the
/// displacement at every sample and end with velocity zero: the second derivative of the cubic
/// spline with level ends. The motion ends at rest where it began if the displacement does, and
/// has no drift that the displacement has not.
/// @param displacement  at least 4 samples, the first 0 [m]
Eigen::VectorXd acceleration_of(double time_step, const Eigen::VectorXd& displacement);

/// 1 in the middle, 0 at 0 s and at `duration` and outside, sin^2 over `taper` at each end.
inline double trapezoid_taper(double time, double duration, double taper) {
  const double to_end = std::min(time, duration - time);
  if (to_end <= 0) return 0;
  if (to_end >= taper) return 1;
  return std::pow(std::sin(std::numbers::pi / 2 * to_end / taper), 2);
}

}  // namespace gurney::groundmotions
