#include "engine/solver/step_control.h"

#include <algorithm>
#include <cmath>

#include "engine/solver/quadrature.h"

namespace gurney {
namespace {

/// Below this an item counts as at rest: its errors need not get smaller [m/s].
constexpr double kLeastSpeed = 0.01;

/// The error of a step grows with its cube; the next one aims at kSafety^3 of what is allowed.
constexpr double kSafety = 0.9, kLeastGrowth = 0.2, kLargestGrowth = 2;

}  // namespace

StepControl::StepControl(const Assembly& assembly, const SimulationSettings& settings)
    : assembly_(assembly),
      tolerance_(kShareOfStep * settings.tolerance),
      shortest_(kShortest * settings.time_step),
      items_(assembly.items.size(), Course{.top_speed = kLeastSpeed}) {}

double StepControl::longest(const Island& island) const {
  double longest = std::numeric_limits<double>::infinity();
  for (std::size_t i : island.items) longest = std::min(longest, items_[i].longest);
  return longest;
}

Vector6 StepControl::velocity_error(double duration, const Vector6& at_start, const Vector6& first,
                                    const Vector6& end) {
  return 2.0 / 3 * duration * (first - (1 - kSdirkGamma) * at_start - kSdirkGamma * end);
}

double StepControl::error(const Trial& trial, std::size_t i) {
  const double reach = assembly_.items[i].reach;
  const auto speed = [&](const Vector6& v) -> double {
    return v.head<3>().norm() + reach * v.tail<3>().norm();
  };
  double& top_speed = items_[i].top_speed;
  top_speed = std::max(top_speed, speed(trial.from.items[i].velocity.chassis));
  const Vector6& first = trial.first.items[i].acceleration.chassis;
  const SlipReversals::Course& before = trial.courses[i];
  const Vector6 error =
      velocity_error(trial.duration, before.known ? before.acceleration.chassis : first, first,
                     trial.end.items[i].acceleration.chassis);
  return speed(error) / (tolerance_ * top_speed);
}

bool StepControl::rejects(const Trial& trial) {
  const double h = trial.duration;
  double worst = trial.converged ? 0 : std::numeric_limits<double>::infinity();
  if (trial.converged)
    for (std::size_t i : trial.island.items) worst = std::max(worst, error(trial, i));
  const bool rejected = !(worst <= 1) && h > 1.01 * shortest_;
  const double change = kSafety / std::cbrt(worst);
  for (std::size_t i : trial.island.items) {
    double& longest = items_[i].longest;
    if (change > kLargestGrowth)  // an event may have shortened this step
      longest = std::max(longest, kLargestGrowth * h);
    else
      longest = std::max(shortest_, h * std::max(change, kLeastGrowth));
  }
  return rejected;
}

}  // namespace gurney
