#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/base/units.h"
#include "engine/run/simulate.h"
#include "studies/verification/scenes/scenes.h"
#include "studies/verification/scenes/small_scenes.h"

// Items on casters that trip, overturn and come to lie on the floor.
namespace gurney {
namespace {

/// A trolley pushed over along `direction` (floor axes) and let go.
Response push_over(const Vector3& direction) {
  Scene scene = scene_of({});
  Tread tread;
  tread.static_friction = tread.kinetic_friction = 1.5;
  scene.items[0].model = small::trolley({0, 0, 0, 0}, tread);
  for (Caster& caster : scene.items[0].model.casters) {
    caster.swivels = false;
    caster.brake_torque = std::numeric_limits<double>::infinity();
  }
  scene.items[0].model.marked_points.clear();
  const BodyShape& box = scene.items[0].model.shape[0];
  for (int k = 0; k < 8; ++k)
    scene.items[0].model.marked_points.push_back(
        {"corner", box.center + 0.5 * box.size.cwiseProduct(Vector3(k & 1 ? 1 : -1, k & 2 ? 1 : -1,
                                                                    k & 4 ? 1 : -1))});
  scene.items[0].loads = {PointForce{"push", {0, 0, 0.9}, direction, {0, 0.6}, {1100, 1100}}};
  SimulationSettings settings;
  settings.settle_time = 20;
  return simulate(scene, {}, settings);
}

TEST(Overturning, IsFollowedUntilTheTrolleyLiesOnTheFloor) {
  for (const Vector3& direction : {Vector3(0, 1, 0), Vector3(0, -1, 0), Vector3(0.6, 0.8, 0)}) {
    const Response response = push_over(direction);
    ASSERT_EQ(response.outcome, Outcome::kOverturned) << response.cause;
    EXPECT_GT(response.items[0].demands.time_of_overturning, 0);
    EXPECT_LT(response.end_time, 20) << "rests before it is cut off";
    // On its side, or on its head.
    EXPECT_GT(response.items[0].history.back().tilt, 80 * kRadiansPerDegree);
    EXPECT_LT(response.quality.energy_closure, 0.01);
    // At rest a corner sinks by the weight over two of them, W / (2 k) = 0.5 mm, at most.
    for (int k = 0; k < 8; ++k) {
      const double start = k & 4 ? 0.9 : 0.2;
      const auto corner = static_cast<std::size_t>(k);
      EXPECT_GT(start + response.items[0].history.back().points[corner].displacement.z(), -1e-3)
          << k;
    }
    EXPECT_EQ(response.quality.unconverged_steps, 0);
    EXPECT_GE(response.items[0].demands.impacts, 1);
    EXPECT_LE(response.items[0].demands.impacts, 30) << "no flood";
    EXPECT_EQ(response.impacts[0].other, "floor");
  }
}

TEST(Overturning, ReportsWhichWayItFellAndWhichWheelsLeftTheFloor) {
  // Pushed to the left, the trolley turns over its left wheels and the right ones lift off.
  const Demands demands = push_over({0, 1, 0}).items[0].demands;
  // Trailing wheels make it not quite symmetric; a wrong axis or sign is off by 90 degrees.
  EXPECT_NEAR(demands.direction_of_overturning, std::numbers::pi / 2, 1 * kRadiansPerDegree);
  const EquipmentModel trolley = small::trolley({0, 0, 0, 0}, Tread());
  for (std::size_t i = 0; i < 4; ++i) {
    const double liftoff = demands.wheels[i].liftoff_before_overturning;
    if (trolley.casters[i].mount.y() > 0) continue;
    EXPECT_GE(liftoff, 0) << i;
    EXPECT_LT(liftoff, demands.time_of_overturning - 0.1) << i;
  }
}

TEST(Overturning, SaysNothingOfAFallThatWasNone) {
  const Demands demands = push_over({0, 0, -0.1}).items[0].demands;
  EXPECT_TRUE(std::isnan(demands.direction_of_overturning));
  for (const WheelDemands& wheel : demands.wheels) EXPECT_LT(wheel.liftoff_before_overturning, 0);
}

TEST(Kerb, AWheelClimbsALowThresholdAndStopsAtAHighKerb) {
  const auto run = [](double height, double speed) {
    Scene scene = scene_of(small::trolley({180, 180, 0, 0}, Tread()));
    for (Caster& caster : scene.items[0].model.casters) caster.swivels = false;
    scene.room.push_back({"threshold",
                          "",
                          {1.0, 0, 0.5 * height - 0.05},
                          Quaternion::Identity(),
                          RoomBox{{0.1, 2, height + 0.1}}});
    scene.items[0].initial.velocity = {speed, 0, 0};
    SimulationSettings settings;
    settings.duration = 2;
    settings.time_step = 0.002;
    return simulate(scene, {}, settings);
  };
  const Response over = run(0.005, 0.8);
  EXPECT_EQ(over.outcome, Outcome::kStopped) << over.cause;
  // The front wheels, at x = 0.43, leave the threshold at 1.05.
  EXPECT_GT(over.items[0].history.back().displacement.x(), 0.7) << "the front wheels are over";
  const Response stopped = run(0.08, 0.8);
  EXPECT_LT(stopped.items[0].demands.peak_displacement_x, 0.6) << "stands before it";
  ASSERT_GE(stopped.impacts.size(), 1u);
  EXPECT_EQ(stopped.impacts[0].other, "threshold");
  EXPECT_GE(stopped.impacts[0].wheel, 0);
}

}  // namespace
}  // namespace gurney
