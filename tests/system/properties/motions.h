#pragma once

#include <rapidcheck.h>

#include <numbers>

#include "engine/run/simulate.h"

/// Items, motions and runs that RapidCheck draws, and makes simpler when a property fails.
namespace gurney::properties {

/// Simpler is nearer to `low`.
inline rc::Gen<double> between(double low, double high) {
  constexpr int kSteps = 1 << 20;
  return rc::gen::map(rc::gen::inRange(0, kSteps + 1), [=](int step) {
    return low + (high - low) * static_cast<double>(step) / kSteps;
  });
}

/// A cart that cannot fall over within a short motion: low, with 3 to 6 casters far apart.
inline EquipmentModel low_cart() {
  EquipmentModel cart;
  const double mass = cart.chassis_mass = *between(10, 300);
  const Vector3 size(*between(0.5, 1), *between(0.5, 1), *between(0.2, 0.5));
  const int count = *rc::gen::inRange(3, 7);
  Caster shared;
  shared.trail = *between(0.01, 0.06);
  shared.wheel_axial_inertia = 0.5 * shared.wheel_mass * 0.05 * 0.05;
  shared.wheel_transverse_inertia = 0.5 * shared.wheel_axial_inertia;
  shared.fork_center_of_mass = {-0.5 * shared.trail, 0, -0.05};
  shared.fork_inertia = solid_box_inertia(shared.fork_mass, {0.05, 0.04, 0.08});
  shared.swivel.coulomb = *between(0, 0.2);
  for (int i = 0; i < count; ++i) {
    Caster& caster = cart.casters.emplace_back(shared);
    const double angle = 2 * std::numbers::pi * i / count;
    caster.mount = {0.5 * size.x() * std::cos(angle), 0.5 * size.y() * std::sin(angle),
                    caster.height};
    caster.heading = *between(0, 2 * std::numbers::pi);
    caster.brake_torque = *rc::gen::element(0.0, 20.0);
  }
  cart.shape = {{Vector3(0, 0, shared.height + 0.5 * size.z()), size}};
  cart.chassis_center_of_mass = {0, *between(0, 0.05), shared.height + 0.4 * size.z()};
  cart.chassis_inertia = solid_box_inertia(mass, size);
  return cart;
}

/// A pulse of one to three waves in two directions, up to 0.5 g.
inline FloorMotion pulse(double duration) {
  constexpr double kStep = 0.005;
  const double x = *between(0.2, 5), y = *between(0, 5);
  const double waves = *between(1, 3);
  Eigen::Matrix3Xd a = Eigen::Matrix3Xd::Zero(3, std::lround(duration / kStep) + 1);
  for (Eigen::Index i = 0; i < a.cols(); ++i) {
    const double phase = kStep * static_cast<double>(i) / duration;
    const double rise = std::sin(std::numbers::pi * phase);
    a(0, i) = x * rise * std::sin(2 * std::numbers::pi * waves * phase);
    a(1, i) = y * rise * std::cos(2 * std::numbers::pi * waves * phase);
  }
  return {kStep, a};
}

}  // namespace gurney::properties
