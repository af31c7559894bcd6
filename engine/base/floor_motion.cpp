#include "engine/base/floor_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/base/error.h"

namespace gurney {
namespace {

/// Exact integral at the samples of what is linear between them.
Eigen::Matrix3Xd integrated(const Eigen::Matrix3Xd& values, double time_step) {
  Eigen::Matrix3Xd result = Eigen::Matrix3Xd::Zero(3, values.cols());
  for (Eigen::Index i = 1; i < values.cols(); ++i)
    result.col(i) = result.col(i - 1) + time_step / 2 * (values.col(i - 1) + values.col(i));
  return result;
}

Eigen::Matrix3Xd rocking_times(double factor, Eigen::Matrix3Xd rotation) {
  rotation.topRows<2>() *= factor;
  return rotation;
}

}  // namespace

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

FloorMotion FloorMotion::with_rotation(const FloorRotation& rotation) const {
  const Eigen::Index samples = acceleration_.cols();
  require(rotation.angle.cols() == samples && rotation.acceleration.cols() == samples,
          "the rotation of a floor must have as many samples as its acceleration, " +
              std::to_string(samples) + ", got " + std::to_string(rotation.angle.cols()) + " and " +
              std::to_string(rotation.acceleration.cols()));
  require(rotation.angle.allFinite() && rotation.acceleration.allFinite(),
          "the rotation of a floor must be finite at every sample");
  FloorMotion result = *this;
  result.angle_ = rotation.angle;
  result.angular_acceleration_ = rotation.acceleration;
  result.angle_integral_ = integrated(result.angle_, time_step_);
  result.angular_velocity_ = integrated(result.angular_acceleration_, time_step_);
  return result;
}

FloorMotion FloorMotion::with_rocking_times(double factor) const {
  if (!rotates() || factor == 1) return *this;
  return with_rotation(
      {rocking_times(factor, angle_), rocking_times(factor, angular_acceleration_)});
}

FloorRotation FloorMotion::rotation() const {
  if (!rotates()) return {};
  return {angle_, angular_acceleration_};
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

Vector3 FloorMotion::integral_at(const Eigen::Matrix3Xd& values, const Eigen::Matrix3Xd& integral,
                                 double time) const {
  if (values.cols() == 0 || time <= 0) return Vector3::Zero();
  const auto last = values.cols() - 1;
  const auto i = std::min(static_cast<Eigen::Index>(time / time_step_), last);
  if (i == last) return integral.col(last);
  const double t = time - time_step_ * static_cast<double>(i);
  const Vector3 a0 = values.col(i), a1 = values.col(i + 1);
  return integral.col(i) + t * a0 + t * t / (2 * time_step_) * (a1 - a0);
}

Vector3 FloorMotion::velocity_at(double time) const {
  return integral_at(acceleration_, velocity_, time);
}

Vector3 FloorMotion::integral_of_angle_at(double time) const {
  return integral_at(angle_, angle_integral_, time);
}

Vector3 FloorMotion::angular_velocity_at(double time) const {
  return integral_at(angular_acceleration_, angular_velocity_, time);
}

Vector3 FloorMotion::residual_velocity() const {
  return at_rest() ? Vector3(Vector3::Zero()) : Vector3(velocity_.rightCols<1>());
}

Vector3 FloorMotion::residual_displacement() const {
  return at_rest() ? Vector3(Vector3::Zero()) : Vector3(displacement_.rightCols<1>());
}

}  // namespace gurney
