#include <gtest/gtest.h>

#include <cmath>

#include "engine/base/units.h"
#include "engine/simulate.h"
#include "studies/verification/scenes/scenes.h"

// Friction is a cone: a locked trolley that slides and is pushed on by F in any direction
// accelerates along it at a = F / M - mu g, and does not move sideways. (A pyramid gives up to
// sqrt(2) mu g at 45 degrees, and pulls the motion to its axes.)
namespace gurney {
namespace {

using namespace scenes;

constexpr double kG = kStandardGravity;

struct Push {
  double force_ratio, mu;  // F / (mu M g), friction
};

constexpr double kSpeed = 1;  // at the start [m/s]

struct Travel {
  double along, across, yaw;  // [m], [m], [rad]
};

Travel push(const EquipmentModel& item, const Push& p, double angle, double duration,
            const Fixture& fixture) {
  Scene scene;
  scene.items[0].model = item;
  const Vector3 direction(std::cos(angle), std::sin(angle), 0);
  scene.items[0].initial.velocity = kSpeed * direction;
  scene.items[0].initial.wheels_roll = false;
  Excitation excitation;
  excitation.fixture = fixture;
  excitation.forces = {constant_force(p.force_ratio * p.mu * total_mass(item) * kG, duration,
                                      item.marked_points[0].position, direction)};
  const auto response = simulate(scene, excitation, run_for(duration, 0.002, duration));
  const Vector3 d = response.items[0].history.back().points[0].displacement;
  return {d.dot(direction), Vector3::UnitZ().cross(direction).dot(d),
          response.items[0].history.back().yaw};
}

EquipmentModel block(double mu, const std::vector<double>& headings = {}) {
  ItemOptions options;
  stiffen(options.caster.tread);
  options.caster.tread.static_friction = options.caster.tread.kinetic_friction = mu;
  options.headings = headings;
  return locked_block(options);
}

class Isotropy : public testing::TestWithParam<Push> {};

// The treads wind up first, which saves f^2 / (2 k) of sliding loss, f = mu M g, and so adds
// f^2 / (2 k M v) to the speed; along a wheel the locked axle (10 k_t) is in series with the tread,
// so a tenth of that differs with the direction. The solve's residual leaves 1e-9 g t^2.
TEST_P(Isotropy, SameAccelerationAlongThePushFrom0To90Degrees) {
  const Push p = GetParam();
  const EquipmentModel item = block(p.mu, {0.1, 0.9, 2.3, 4});
  constexpr double kDuration = 1;
  const double exact =
      kSpeed * kDuration + 0.5 * (p.force_ratio - 1) * p.mu * kG * kDuration * kDuration;
  const double mass = total_mass(item), friction = p.mu * mass * kG;
  const double wind_up = friction * friction / (2 * 4e9 * mass * kSpeed) * kDuration;
  const double residual = 1e-9 * kG * kDuration * kDuration;
  for (int degrees = 0; degrees <= 90; degrees += 10) {
    SCOPED_TRACE(degrees);
    const Travel travel = push(item, p, degrees * kRadiansPerDegree, kDuration, hold_rotations());
    EXPECT_NEAR(travel.along, exact, 1.1 * wind_up + residual);
    EXPECT_NEAR(travel.across, 0, 0.1 * wind_up + residual);
  }
}

// Free to pitch, roll and yaw: friction on the floor tilts the load towards the front wheels, N_i =
// N + alpha x_i + beta y_i, with moments of friction that cancel about the vertical. While the tilt
// swings in, for some 3 ms, pitch and roll are out of step: a moment up to mu^2 M g h / 2 turns it
// by 8e-4 rad in what follows (mu 0.15, 12 kg m2).
TEST(FreeIsotropy, SameWithFreeRotations) {
  const Push p{1.5, 0.15};  // mu h well below the half track: it does not tip
  const EquipmentModel item = block(p.mu);
  constexpr double kDuration = 0.5;
  const double exact =
      kSpeed * kDuration + 0.5 * (p.force_ratio - 1) * p.mu * kG * kDuration * kDuration;
  for (int degrees = 0; degrees <= 90; degrees += 15) {
    SCOPED_TRACE(degrees);
    const Travel travel = push(item, p, degrees * kRadiansPerDegree, kDuration, {});
    EXPECT_NEAR(travel.along, exact, 1e-4 * exact);
    EXPECT_NEAR(travel.across, 0, 1e-4 * exact);
    EXPECT_NEAR(travel.yaw, 0, 8e-4);
  }
}

// Stick is as isotropic as sliding: at 0.99 of mu_s M g nothing slides, at 1.01 it goes, with mu_k
// from then on.
TEST_P(Isotropy, SameStaticLimitInAllDirections) {
  const Push p = GetParam();
  EquipmentModel item = block(p.mu);
  for (Caster& caster : item.casters) caster.tread.static_friction = 1.3 * p.mu;
  for (int degrees = 0; degrees <= 90; degrees += 15) {
    SCOPED_TRACE(degrees);
    const double angle = degrees * kRadiansPerDegree;
    // A sudden force swings the treads to twice its static stretch: ramp it over 0.5 s.
    const auto ramped = [&](double ratio) {
      Scene scene;
      scene.items[0].model = item;
      const double force = ratio * 1.3 * p.mu * total_mass(item) * kG;
      Excitation excitation;
      excitation.fixture = hold_rotations();
      excitation.forces = {{"push",
                            item.marked_points[0].position,
                            Vector3(std::cos(angle), std::sin(angle), 0),
                            {0, 0.5, 1.5},
                            {0, force, force}}};
      return simulate(scene, excitation, run_for(1.5, 0.002))
          .items[0]
          .demands.residual_displacement;
    };
    EXPECT_LT(ramped(0.99), 1e-6);
    // mu_k once it moves: from 0.5 s on at (1.01 * 1.3 - 1) mu g, a little earlier in the ramp.
    const double rate = (1.01 * 1.3 - 1) * p.mu * kG;
    EXPECT_NEAR(ramped(1.01), 0.5 * rate, 0.03 * rate);
  }
}

INSTANTIATE_TEST_SUITE_P(Pushes, Isotropy,
                         testing::Values(Push{1.5, 0.3}, Push{2, 0.1}, Push{1.2, 0.6}));

}  // namespace
}  // namespace gurney
