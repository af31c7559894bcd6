#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "engine/run/simulate.h"
#include "studies/verification/scenes/blocks.h"
#include "studies/verification/scenes/small_scenes.h"

// Several items in one scene: what they do to each other, and that those apart know nothing of it.
// Blocks that collide are cases of `gurney verify impacts`.
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

TEST(Neighbours, AnImpactNamesBothItemsAndCountsForBoth) {
  Scene scene = blocks::block(80, {0.5, 0.4, 0.6}, slippery());
  const PlacedItem second = blocks::block(20, {0.3, 0.3, 0.6}, slippery()).items[0];
  scene.items = {at(scene.items[0], "heavy", Vector3::Zero(), {0.8, 0, 0}),
                 at(second, "light", {0.5, 0, 0}, Vector3::Zero())};
  scene.pairs.push_back({"steel", "steel", {.restitution = 0.7, .friction = 0}});
  const Response response = simulate(scene, {}, blocks::run_for(0.5, 0.004, 0.004));
  ASSERT_EQ(response.impacts.size(), 1u);
  const Impact& impact = response.impacts[0];
  EXPECT_EQ(impact.item, 0u);
  EXPECT_EQ(impact.other_item, 1);
  EXPECT_EQ(impact.body, "chassis");
  EXPECT_EQ(impact.other, "light");
  EXPECT_EQ(impact.other_body, "chassis");
  for (const ItemResponse& item : response.items) EXPECT_EQ(item.demands.impacts, 1);
}

TEST(Neighbours, OneThatIsNotTouchedMakesNoStepShorter) {
  const auto event_steps = [](bool neighbour) {
    const Vector3 size(0.5, 0.4, 0.6);
    Scene scene = blocks::block(80, size, slippery());
    blocks::add_wall(scene, 0.26, {.restitution = 0.1, .friction = 0});
    const PlacedItem block = scene.items[0];
    scene.items = {at(block, "moving", Vector3::Zero(), {0.5, 0, 0})};
    if (neighbour) scene.items.push_back(at(block, "beside", {0, 0.41, 0}, Vector3::Zero()));
    scene.pairs.push_back({"steel", "steel", slippery()});
    const Response response = simulate(scene, {}, blocks::run_for(0.1, 0.004, 0.004));
    EXPECT_EQ(response.impacts.size(), 1u);
    return response.quality.event_steps;
  };
  EXPECT_EQ(event_steps(true), event_steps(false));
  EXPECT_GT(event_steps(true), 20);
}

Scene two_trolleys(double gap, double speed, double height) {
  Scene scene = scene_of({});
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

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

// Every kind of load, a spring of the fixture and an initial motion, on the second of two items.
PlacedItem pulled(PlacedItem item) {
  item.loads = {PointForce{"pull", {0, 0, 0.5}, {1, 0, 0}, {0, 1, 3}, {0, 40, 10}},
                StringPotentiometer{{-0.5, 0, 0.4}, {-1, 0, 0}, 2},
                DropWeight{.point = {0.5, 0, 0.3}, .mass = 5, .drop_height = 0.3},
                Blocks{{0.4, 0, 0.1}, 1e6, 1e3, 0.5}};
  item.fixture.guides[1] = {Guide::Kind::kSpring, 0, 500, 20};
  item.initial.yaw_rate = 0.2;
  return item;
}

TEST(Neighbours, TheSecondItemIsPulledAsIfAlone) {
  Scene both = two_trolleys(8, 0, 0.5);
  both.items[1] = pulled(both.items[1]);
  Scene one = both;
  one.items = {both.items[1]};
  const auto settings = blocks::run_for(4, 0.004, 0.02);
  const Response together = simulate(both, {}, settings), alone = simulate(one, {}, settings);
  const auto &a = together.items[1].history, &b = alone.items[0].history;
  ASSERT_EQ(a.size(), b.size());
  EXPECT_GT(b.back().displacement.x(), 0.2);
  for (std::size_t k = 0; k < a.size(); ++k) {
    for (int axis = 0; axis < 3; ++axis)
      ASSERT_TRUE(same_bits(a[k].displacement[axis], b[k].displacement[axis])) << a[k].time;
    ASSERT_TRUE(same_bits(a[k].pull_force, b[k].pull_force)) << a[k].time;
    ASSERT_TRUE(same_bits(a[k].cable_tension, b[k].cable_tension)) << a[k].time;
    ASSERT_TRUE(same_bits(a[k].energy.weight_energy, b[k].energy.weight_energy)) << a[k].time;
  }
  EXPECT_LT(together.items[0].demands.peak_displacement, 1e-6) << "nothing acts on the first";
}

TEST(Neighbours, ItemsThatNeverMeetMoveAsIfAlone) {
  const FloorMotion floor = small::noise_record(7, 6, {3, 2, 1});
  Scene both = two_trolleys(8, 0, 0.5);
  const Response together = simulate(both, floor, blocks::run_for(7, 0.004, 0.02));
  for (std::size_t i = 0; i < 2; ++i) {
    Scene one = both;
    one.items = {both.items[i]};
    const Response alone = simulate(one, floor, blocks::run_for(7, 0.004, 0.02));
    const auto &a = together.items[i].history, &b = alone.items[0].history;
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k) {
      ASSERT_TRUE(same_bits(a[k].displacement.x(), b[k].displacement.x())) << "at " << a[k].time;
      ASSERT_TRUE(same_bits(a[k].yaw, b[k].yaw)) << "at " << a[k].time;
      ASSERT_TRUE(same_bits(a[k].energy.loss(), b[k].energy.loss())) << "at " << a[k].time;
    }
  }
}

}  // namespace
}  // namespace gurney
