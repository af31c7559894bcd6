#include <gtest/gtest.h>

#include <cmath>

#include "engine/base/units.h"
#include "engine/simulate.h"
#include "studies/verification/scenes/small_scenes.h"
#include "studies/verification/scenes/blocks.h"

// The floor drops away faster than gravity, then comes back: the trolley flies and lands.
namespace gurney {
namespace {

struct Drop {
  double acceleration;  // of the floor, down and then up; 1..2: it lands meanwhile [g]
  double time;          // of each [s]
};

FloorMotion dropping_floor(const Drop& drop) {
  constexpr double kStep = 0.001;
  const Eigen::Index half = std::lround(drop.time / kStep);
  Eigen::Matrix3Xd acceleration = Eigen::Matrix3Xd::Zero(3, 2 * half + 1);
  acceleration.row(2).head(half).setConstant(-drop.acceleration * kStandardGravity);
  acceleration.row(2).tail(half).setConstant(drop.acceleration * kStandardGravity);
  return {kStep, acceleration};
}

class Flight : public testing::TestWithParam<Drop> {};

// Relative to the floor the trolley rises with (a - g) for the time T and falls back with (a + g):
// it lands after T + t, (a + g) t^2 = (a - g) (T^2 + 2 T t), with the speed (a + g) t - (a - g) T.
TEST_P(Flight, LandsWhenAndAsFastAsABodyInFreeFall) {
  const double a = GetParam().acceleration, T = GetParam().time;
  constexpr double kStiff = 3e7;
  const std::vector<double> kSymmetric{0, 0, 180, 180};  // equal loads: it does not pitch
  Scene scene;
  scene.items[0].model = small::trolley(kSymmetric, small::bare_tread(kStiff, kStiff));
  Excitation excitation;
  excitation.floor = dropping_floor(GetParam());
  const double t = T * ((a - 1) + std::sqrt((a - 1) * (a - 1) + (a + 1) * (a - 1))) / (a + 1);
  const double speed = ((a + 1) * t - (a - 1) * T) * kStandardGravity;
  const Response response = simulate(scene, excitation, blocks::run_for(T + t + 0.02, 1e-4, 1e-4));
  ASSERT_EQ(response.outcome, Outcome::kStopped) << response.cause;
  double take_off = -1, landing = -1, approach = 0;
  for (const Sample& s : response.items[0].history) {
    const bool up = s.wheels[0].mode == WheelMode::kLifted;
    if (up && take_off < 0) take_off = s.time;
    if (up && landing < 0) approach = -s.velocity.z();
    if (!up && take_off >= 0 && landing < 0) landing = s.time;
  }
  // The treads hold the trolley for a quarter of the period of heave, 2 pi sqrt(M / 4 k) = 6 ms,
  // and throw it with their energy: sqrt(M g^2 / 4 k) = 9 mm/s, less than 1 ms on the way. The
  // samples of the record are joined by lines: 1 ms between the two accelerations.
  EXPECT_LT(take_off, 0.004);
  EXPECT_NEAR(landing, T + t, 0.003);
  EXPECT_NEAR(approach, speed, 0.003 * (a + 1) * kStandardGravity);
  EXPECT_EQ(response.items[0].demands.most_wheels_lifted, 4);
  EXPECT_LT(response.quality.energy_closure, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Drops, Flight,
                         testing::Values(Drop{1.5, 0.1}, Drop{1.2, 0.3}, Drop{1.8, 0.08}));

// Elastic treads without friction give a wheel that meets a wall its speed back.
TEST(WheelAtAWall, ReboundsAsFastAsItCame) {
  for (double speed : {0.3, 1.0, 2.0})
    for (bool swivels : {false, true}) {
      Scene scene;
      Tread tread = small::bare_tread(3e5, 1e5);
      tread.static_friction = tread.kinetic_friction = 0;
      scene.items[0].model = small::trolley({0, 0, 0, 0}, tread);
      for (Caster& caster : scene.items[0].model.casters) {
        caster.swivels = swivels;
        caster.mount.z() = caster.height;
      }
      scene.items[0].model.shape = {{{0, 0, 0.8}, {0.2, 0.2, 0.2}}};
      scene.items[0].initial.velocity = {speed, 0, 0};
      scene.room = {{"wall", "", {0.65, 0, 0.5}, Quaternion::Identity(), RoomBox{{0.2, 4, 1}}}};
      Excitation excitation;
      for (int dof : {2, 3, 4}) excitation.fixture.guides[dof] = {Guide::Kind::kHeld, 0, 0, 0};
      const Response response =
          simulate(scene, excitation, blocks::run_for(0.4 / speed, 0.004, 0.004));
      ASSERT_EQ(response.outcome, Outcome::kStopped) << response.cause;
      ASSERT_GE(response.impacts.size(), 2u);
      // 32 steps of a second-order method in half a period of the spring: 0.1 % of the speed.
      EXPECT_NEAR(response.items[0].history.back().velocity.x(), -speed, 0.003 * speed)
          << speed << " m/s, swivels " << swivels;
      EXPECT_LT(response.quality.energy_closure, 0.005) << speed << ", swivels " << swivels;
    }
}

}  // namespace
}  // namespace gurney
