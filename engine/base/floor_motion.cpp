#include "engine/base/floor_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/base/error.h"

namespace gurney {

FloorMotion::FloorMotion(double time_step, Eigen::Matrix3Xd acceleration, std::string name)
    : time_step_(time_step), acceleration_(std::move(acceleration)), name_(std::move(name)) {
  require(time_step_ > 0 && std::isfinite(time_step_),
          "the time step of a floor motion must be positive, got " + std::to_string(time_step_));
  require(acceleration_.allFinite(), "a floor motion must be finite at every sample");
  const Eigen::Index samples = acceleration_.cols();
  velocity_ = Eigen::Matrix3Xd::Zero(3, samples);
  displacement_ = Eigen::Matrix3Xd::Zero(3, samples);
  for (Eigen::Index i = 1; i < samples; ++i) {
    const Vector3 a0 = acceleration_.col(i - 1), a1 = acceleration_.col(i);
    const Vector3 v0 = velocity_.col(i - 1);
    velocity_.col(i) = v0 + time_step_ / 2 * (a0 + a1);
    displacement_.col(i) =
        displacement_.col(i - 1) + time_step_ * v0 + time_step_ * time_step_ / 6 * (2 * a0 + a1);
  }
}

double FloorMotion::duration() const {
  return at_rest() ? 0.0 : time_step_ * static_cast<double>(acceleration_.cols() - 1);
}

Vector3 FloorMotion::acceleration_at(double time) const {
  if (at_rest() || time < 0 || time > duration()) return Vector3::Zero();
  const auto last = acceleration_.cols() - 1;
  const auto i = std::min(static_cast<Eigen::Index>(time / time_step_), last);
  if (i == last) return acceleration_.col(last);
  const double s = time / time_step_ - static_cast<double>(i);
  return (1 - s) * acceleration_.col(i) + s * acceleration_.col(i + 1);
}

Vector3 FloorMotion::velocity_at(double time) const {
  if (at_rest() || time <= 0) return Vector3::Zero();
  const auto last = acceleration_.cols() - 1;
  const auto i = std::min(static_cast<Eigen::Index>(time / time_step_), last);
  if (i == last) return velocity_.col(last);
  const double t = time - time_step_ * static_cast<double>(i);
  const Vector3 a0 = acceleration_.col(i), a1 = acceleration_.col(i + 1);
  return velocity_.col(i) + t * a0 + t * t / (2 * time_step_) * (a1 - a0);
}

Vector3 FloorMotion::residual_velocity() const {
  return at_rest() ? Vector3(Vector3::Zero()) : Vector3(velocity_.rightCols<1>());
}

Vector3 FloorMotion::residual_displacement() const {
  return at_rest() ? Vector3(Vector3::Zero()) : Vector3(displacement_.rightCols<1>());
}

}  // namespace gurney
