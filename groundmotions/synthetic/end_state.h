#pragma once

#include <Eigen/Core>

namespace gurney::groundmotions {

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

}  // namespace gurney::groundmotions
