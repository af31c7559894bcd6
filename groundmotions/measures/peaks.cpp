#include "groundmotions/measures/peaks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "engine/base/units.h"

namespace gurney::groundmotions {
namespace {

constexpr double kMeanAcceleration = 1e-4 * kStandardGravity;  // [m/s2]
constexpr double kInvisibleVelocity = 0.01;                    // [m/s]
constexpr double kVisibleDisplacement = 0.05;                  // [m]
constexpr double kShareOfPeak = 0.5;

/// Largest horizontal displacement of the floor at a sample.
double peak_displacement(const FloorMotion& floor) {
  const auto& a = floor.acceleration();
  return peaks(floor.time_step(), a.row(0), a.row(1)).displacement;
}

}  // namespace

Peaks peaks(double time_step, const Eigen::VectorXd& a) {
  if (a.size() == 0) return {};
  const IntegratedMotion motion = integrated(time_step, a);
  Eigen::Index at = 0;
  const double largest = a.cwiseAbs().maxCoeff(&at);
  return {largest, motion.velocity.cwiseAbs().maxCoeff(), motion.displacement.cwiseAbs().maxCoeff(),
          static_cast<double>(at) * time_step};
}

Peaks peaks(double time_step, const Eigen::VectorXd& h1, const Eigen::VectorXd& h2) {
  assert(h1.size() == h2.size());
  if (h1.size() == 0) return {};
  const IntegratedMotion one = integrated(time_step, h1), two = integrated(time_step, h2);
  const auto length = [](const Eigen::VectorXd& x, const Eigen::VectorXd& y) -> Eigen::VectorXd {
    return (x.array().square() + y.array().square()).sqrt();
  };
  Eigen::Index at = 0;
  const double largest = length(h1, h2).maxCoeff(&at);
  return {largest, length(one.velocity, two.velocity).maxCoeff(),
          length(one.displacement, two.displacement).maxCoeff(),
          static_cast<double>(at) * time_step};
}

IntegratedMotion integrated(double time_step, const Eigen::VectorXd& acceleration) {
  const Eigen::Index samples = acceleration.size();
  IntegratedMotion motion{Eigen::VectorXd::Zero(samples), Eigen::VectorXd::Zero(samples)};
  for (Eigen::Index i = 1; i < samples; ++i) {
    const double a0 = acceleration[i - 1], a1 = acceleration[i], v0 = motion.velocity[i - 1];
    motion.velocity[i] = v0 + time_step / 2 * (a0 + a1);
    motion.displacement[i] =
        motion.displacement[i - 1] + time_step * v0 + time_step * time_step / 6 * (2 * a0 + a1);
  }
  return motion;
}

EndMotion end_motion(double time_step, const Eigen::VectorXd& acceleration) {
  if (acceleration.size() == 0) return {};
  const IntegratedMotion motion = integrated(time_step, acceleration);
  return {motion.velocity[acceleration.size() - 1], motion.displacement[acceleration.size() - 1]};
}

Residual residual(const FloorMotion& floor) {
  Residual result;
  if (floor.at_rest()) return result;
  result.velocity = floor.residual_velocity();
  result.displacement = floor.residual_displacement();

  const double duration = floor.duration();
  const double speed = result.velocity.head<2>().norm();
  const double allowed =
      std::clamp(kMeanAcceleration * duration, kInvisibleVelocity, kVisibleVelocity);
  if (speed > allowed)
    result.warnings.push_back(fmt::format(
        "the floor still moves at {:.3g} m/s when the record ends ({:.3g} m/s are plausible after "
        "{:.3g} s): the same as a constant baseline error of {:.2g} g, which alone carries a free "
        "roller {:.2g} m; correct the baseline of the record",
        speed, allowed, duration, speed / duration / kStandardGravity, speed * duration / 2));

  const double away = result.displacement.head<2>().norm();
  const double peak = peak_displacement(floor);
  if (away > kVisibleDisplacement && away > kShareOfPeak * peak)
    result.warnings.push_back(fmt::format(
        "the floor ends {:.3g} m from where it began (its largest displacement is {:.3g} m): "
        "either "
        "permanent ground displacement near a fault or a baseline error; check the record",
        away, peak));
  return result;
}

}  // namespace gurney::groundmotions
