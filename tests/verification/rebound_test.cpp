#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/simulate.h"
#include "tests/support/blocks.h"

// Rebound from the room at the default step of 4 ms, and what the impact leaves of the motion.
namespace gurney {
namespace {

constexpr double kMass = 80, kGap = 0.1, kStep = 0.004;
const Vector3 kSize(0.5, 0.4, 0.6);

Vector3 turned(double yaw, const Vector3& v) {
  return Eigen::AngleAxisd(yaw, Vector3::UnitZ()) * v;
}

/// A block that meets a wall whose normal is turned by `yaw`, at `speed` along it.
Scene towards_wall(double yaw, double speed, const ContactConstants& wall) {
  Scene scene = blocks::block(kMass, kSize, {.friction = 0});
  blocks::add_wall(scene, 0.5 * kSize.x() + kGap, wall);
  RoomShape& shape = scene.room.back();
  shape.rotation = Quaternion(Eigen::AngleAxisd(yaw, Vector3::UnitZ()));
  shape.position = turned(yaw, shape.position);
  scene.initial.yaw = yaw;
  scene.initial.velocity = turned(yaw, {speed, 0, 0});
  return scene;
}

TEST(Rebound, AFlatFaceReboundsWithTheRestitutionStatedAtTheDefaultStep) {
  for (double yaw : {0.0, std::numbers::pi / 6})
    for (double e : {0.2, 0.5, 0.7, 0.9})
      for (double speed : {0.2, 0.8, 2.0}) {
        const Scene scene = towards_wall(yaw, speed, {.restitution = e, .friction = 0});
        const Response r = simulate(scene, {}, blocks::run_for(2 * kGap / speed, kStep, kStep));
        const Vector3 v = turned(-yaw, r.history.back().velocity);
        printf("yaw %g e %g v %g: %g %g %g  err/v %g impacts %zu closure %g steps %ld\n", yaw, e,
               speed, v.x(), v.y(), v.z(), (-v.x() - e * speed) / speed, r.impacts.size(),
               r.quality.energy_closure, (long)r.quality.steps);
        EXPECT_NEAR(-v.x(), e * speed, 0.01 * speed);
      }
}

}  // namespace
}  // namespace gurney
