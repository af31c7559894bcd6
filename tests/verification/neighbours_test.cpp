#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "engine/simulate.h"
#include "studies/verification/scenes/small_scenes.h"
#include "studies/verification/scenes/blocks.h"

// Several items in one scene: what they do to each other, and that those apart know nothing of it.
namespace gurney {
namespace {

ContactConstants slippery() { return {.friction = 0}; }

PlacedItem at(PlacedItem item, const std::string& name, const Vector3& position,
              const Vector3& velocity) {
  item.name = name;
  item.initial.position = position;
  item.initial.velocity = velocity;
  return item;
}

/// A heavy block that slides along x into a light one, whose middle is `offset` to the side.
Scene two_blocks(double heavy, double light, double speed, double offset,
                 const ContactConstants& steel_on_steel) {
  Scene scene = blocks::block(heavy, {0.5, 0.4, 0.6}, slippery());
  const PlacedItem second = blocks::block(light, {0.3, 0.3, 0.6}, slippery()).items[0];
  scene.items = {at(scene.items[0], "heavy", Vector3::Zero(), {speed, 0, 0}),
                 at(second, "light", {0.5, offset, 0}, Vector3::Zero())};
  scene.pairs.push_back({"steel", "steel", steel_on_steel});
  return scene;
}

Vector3 final_velocity(const Response& response, std::size_t item) {
  return response.items[item].history.back().points[0].velocity;
}

TEST(Neighbours, ABlockHitsABlockWithMomentumAndRestitutionKept) {
  for (double e : {0.2, 0.7, 1.0})
    for (double light : {20.0, 80.0, 200.0}) {
      const double heavy = 80, v = 0.8;
      const Response response =
          simulate(two_blocks(heavy, light, v, 0, {.restitution = e, .friction = 0}), {},
                   blocks::run_for(0.5, 0.004, 0.004));
      ASSERT_EQ(response.impacts.size(), 1u);
      const double a = final_velocity(response, 0).x(), b = final_velocity(response, 1).x();
      // The error of the rebound from a wall (wall_impact_test.cpp) is that of the relative speed.
      EXPECT_NEAR(b - a, e * v, 0.003 * v) << "e " << e << ", " << light << " kg";
      // A residual of 1e-9 M g dt in each of the 2500 steps at most.
      EXPECT_NEAR(heavy * a + light * b, heavy * v, 2500 * 1e-9 * (heavy + light) * 9.81 * 2e-4);
      const Impact& impact = response.impacts[0];
      EXPECT_EQ(impact.item, 0u);
      EXPECT_EQ(impact.other_item, 1);
      EXPECT_EQ(impact.body, "chassis");
      EXPECT_EQ(impact.other, "light");
      EXPECT_EQ(impact.other_body, "chassis");
      EXPECT_NEAR(impact.approach_speed, v, 1e-6);
      EXPECT_NEAR(impact.impulse, light * b, 1e-6 * light * b);
      EXPECT_NEAR(impact.normal.x(), -1, 1e-9);
      for (const ItemResponse& item : response.items) EXPECT_EQ(item.demands.impacts, 1);
    }
}

// The impulse P acts at the middle of the light block's face, since its face lies within the heavy
// one's, and passes the heavy block's centre at the offset: v_rel after = -e v at that point,
// P = (1 + e) v / (1 / M + offset^2 / I + 1 / m).
TEST(Neighbours, AnImpactOffCenterTurnsTheHitBlock) {
  const double heavy = 80, light = 20, v = 0.8, e = 0.5, offset = 0.04;
  const Response response =
      simulate(two_blocks(heavy, light, v, offset, {.restitution = e, .friction = 0}), {},
               blocks::run_for(0.32, 0.004, 0.004));
  ASSERT_GE(response.impacts.size(), 1u);
  const double inertia = heavy * (0.5 * 0.5 + 0.4 * 0.4) / 12;
  const double momentum =
      heavy * final_velocity(response, 0).x() + light * final_velocity(response, 1).x();
  EXPECT_NEAR(momentum, heavy * v, 1e-6 * heavy * v);
  const double impulse = (1 + e) * v / (1 / heavy + offset * offset / inertia + 1 / light);
  EXPECT_NEAR(light * final_velocity(response, 1).x(), impulse, 0.02 * impulse);
  EXPECT_LT(response.quality.energy_closure, 0.01);
}

// A push on the first of two blocks before a wall goes through both: at rest each pair of faces,
// four corners of stiffness k, is pressed together by F / 4 k.
TEST(Neighbours, AReachedWallHoldsTheWholeRow) {
  const double push = 200, k = 1e6, gap = 1e-3;
  Scene scene = two_blocks(80, 20, 0, 0, {.stiffness = k, .restitution = 0.3, .friction = 0});
  scene.items[1].initial.position.x() = 0.25 + gap + 0.15;
  blocks::add_wall(scene, 0.25 + gap + 0.3 + gap, {.stiffness = k, .friction = 0});
  Excitation excitation;
  excitation.forces = {{"push", {0, 0, 0.3}, {1, 0, 0}, {0, 10}, {push, push}}};
  const Response response = simulate(scene, excitation, blocks::run_for(3, 0.004, 0.1));
  ASSERT_EQ(response.outcome, Outcome::kStopped) << response.cause;
  const Sample &first = response.items[0].history.back(),
               &second = response.items[1].history.back();
  EXPECT_LT(first.velocity.norm(), 1e-6);
  // Both corners of a height carry the same; the push is at the height of the middle.
  EXPECT_NEAR(second.displacement.x(), gap + push / (4 * k), 1e-7);
  EXPECT_NEAR(first.displacement.x(), 2 * gap + 2 * push / (4 * k), 2e-7);
  EXPECT_EQ(response.quality.subdivided_steps, 0);
  EXPECT_LT(response.quality.newton_iterations, 5 * response.quality.steps);
}

Scene two_trolleys(double gap, double speed, double height) {
  Scene scene;
  EquipmentModel model = small::trolley({10, 100, 200, 300}, Tread());
  model.shape = {{{0, 0, height}, {1, 0.6, 0.3}}};
  scene.items[0].model = model;
  scene.items = {at(scene.items[0], "left", Vector3::Zero(), {speed, 0, 0}),
                 at(scene.items[0], "right", {1 + gap, 0.1, 0}, {-speed, 0, 0})};
  return scene;
}

TEST(Neighbours, TrolleysThatCollideKeepTheirEnergyAccounts) {
  const Response response =
      simulate(two_trolleys(0.2, 0.8, 0.5), {}, blocks::run_for(3, 0.002, 0.01));
  ASSERT_EQ(response.outcome, Outcome::kStopped) << response.cause;
  ASSERT_GE(response.impacts.size(), 1u);
  const EnergyAccount &a = response.items[0].energy, &b = response.items[1].energy;
  EXPECT_GT(std::abs(a.work_of_neighbours), 0.1);
  EXPECT_NEAR(a.work_of_neighbours + b.work_of_neighbours, 0,
              1e-9 * std::abs(a.work_of_neighbours));
  EXPECT_LT(response.quality.energy_closure, 0.01);
  // Newton's method knows how the items push each other: a few iterations in each of two stages.
  EXPECT_EQ(response.quality.subdivided_steps, 0);
  EXPECT_LT(response.quality.newton_iterations, 5 * response.quality.steps);
}

// The chassis are above the casters' reach and narrower than these: wheels meet wheels.
TEST(Neighbours, WheelsMeetWheels) {
  Scene scene = two_trolleys(0.25, 0.6, 0.5);
  for (PlacedItem& item : scene.items) item.model.shape[0].size = {0.5, 0.4, 0.3};
  scene.items[1].initial.position.y() = 0;
  const Response response = simulate(scene, {}, blocks::run_for(3, 0.004, 0.02));
  ASSERT_EQ(response.outcome, Outcome::kStopped) << response.cause;
  ASSERT_GE(response.impacts.size(), 1u);
  for (const Impact& impact : response.impacts) {
    EXPECT_GE(impact.wheel, 0);
    EXPECT_NE(impact.other_body, "chassis");
    EXPECT_GE(impact.peak_force, 0);
  }
  EXPECT_LT(response.items[0].history.back().displacement.x(), 0.25);
  EXPECT_LT(response.quality.energy_closure, 0.02);
}

bool same(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

TEST(Neighbours, ItemsThatNeverMeetMoveAsIfAlone) {
  Excitation excitation;
  excitation.floor = small::noise_record(7, 6, {3, 2, 1});
  Scene both = two_trolleys(8, 0, 0.5);
  const Response together = simulate(both, excitation, blocks::run_for(7, 0.004, 0.02));
  for (std::size_t i = 0; i < 2; ++i) {
    Scene one = both;
    one.items = {both.items[i]};
    const Response alone = simulate(one, excitation, blocks::run_for(7, 0.004, 0.02));
    const auto &a = together.items[i].history, &b = alone.items[0].history;
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k) {
      ASSERT_TRUE(same(a[k].displacement.x(), b[k].displacement.x())) << "at " << a[k].time;
      ASSERT_TRUE(same(a[k].yaw, b[k].yaw)) << "at " << a[k].time;
      ASSERT_TRUE(same(a[k].energy.loss(), b[k].energy.loss())) << "at " << a[k].time;
    }
  }
}

}  // namespace
}  // namespace gurney
