#include <gtest/gtest.h>

#include <cmath>

#include "engine/run/simulate.h"
#include "studies/verification/scenes/blocks.h"

// What a run reports of a block that hits a wall. The numbers are cases of `gurney verify impacts`.
namespace gurney {
namespace {

constexpr double kMass = 80, kGap = 0.1, kStep = 0.004;
const Vector3 kSize(0.5, 0.4, 0.6);

Response hit(double speed, const ContactConstants& wall) {
  Scene scene = blocks::block(kMass, kSize, {.friction = 0});
  blocks::add_wall(scene, 0.5 * kSize.x() + kGap, wall);
  scene.items[0].initial.velocity = {speed, 0, 0};
  return simulate(scene, {}, blocks::run_for(2.5 * kGap / speed, kStep, kStep));
}

TEST(WallImpact, RestitutionStatesNoForce) {
  for (double e : {0.05, 0.4, 1.0}) {
    const double speed = 1;
    const Response response = hit(speed, {.restitution = e, .friction = 0});
    ASSERT_EQ(response.impacts.size(), 1u);
    const Impact& impact = response.impacts[0];
    EXPECT_EQ(impact.body, "chassis");
    EXPECT_EQ(impact.other, "wall");
    EXPECT_TRUE(std::isnan(impact.peak_force));
    // The block slides freely but for the wall: whatever accelerates it is numerical.
    const PointDemands& point = response.items[0].demands.points[0];
    EXPECT_GT(point.numerical_acceleration, speed / impact.duration);
    EXPECT_TRUE(std::isnan(point.impact_acceleration));
  }
}

TEST(WallImpact, StatedStiffnessDoes) {
  const Response response =
      hit(0.8, {.kind = ContactConstants::Kind::kCompliant, .stiffness = 4e5, .friction = 0});
  ASSERT_EQ(response.impacts.size(), 1u);
  EXPECT_GT(response.impacts[0].peak_force, 0);
  EXPECT_GT(response.items[0].demands.points[0].impact_acceleration, 0);
  EXPECT_TRUE(std::isnan(response.items[0].demands.points[0].numerical_acceleration));
}

TEST(WallImpact, FrictionTakesItsPartOfTheNormalImpulseAndNoMore) {
  // Guides keep the block from turning, so all points slide alike: J_t = mu J_n until sliding ends.
  for (double mu : {0.1, 0.4})
    for (double e : {0.2, 0.7})
      for (double along : {0.3, 1.5}) {
        const double speed = 0.8;
        Scene scene = blocks::block(kMass, kSize, {.friction = 0});
        scene.items[0].initial.velocity = {speed, along, 0};
        for (int dof : {3, 4, 5}) scene.items[0].fixture.guides[dof].kind = Guide::Kind::kHeld;
        blocks::add_wall(scene, 0.5 * kSize.x() + kGap, {.restitution = e, .friction = mu});
        // Sliding ends and begins inside a step: half of one part in 32 of its work, itself at most
        // an eighth of the energy, may be missing.
        const Response response = simulate(
            scene, {}, blocks::run_for(2.5 * kGap / std::hypot(speed, along), kStep, kStep));
        ASSERT_EQ(response.outcome, Outcome::kStopped) << response.cause;
        EXPECT_LT(response.quality.energy_closure, 2e-3);
        const Vector3& v = response.items[0].history.back().velocity;
        const std::string which = "mu " + std::to_string(mu) + ", e " + std::to_string(e) +
                                  ", along " + std::to_string(along);
        EXPECT_NEAR(-v.x(), e * speed, 0.002 * speed) << which;
        const double taken = along - v.y(), most = mu * (1 + e) * speed;
        EXPECT_LE(taken, most * 1.004) << which;  // the normal impulse's, as above
        if (most < 0.8 * along) {
          EXPECT_NEAR(taken, most, 0.004 * most) << which;
        }
        EXPECT_LT(v.squaredNorm(), speed * speed + along * along) << which;
      }
}

}  // namespace
}  // namespace gurney
