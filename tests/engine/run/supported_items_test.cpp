#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/base/error.h"
#include "engine/run/overlaps.h"
#include "engine/run/simulate.h"
#include "studies/verification/scenes/blocks.h"
#include "studies/verification/scenes/small_scenes.h"

// Items that stand on other items and on shapes of the room, against closed forms.
namespace gurney {
namespace {

constexpr double kGravity = 9.80665;

ContactConstants rough(double friction, double restitution = 0.05) {
  ContactConstants constants;
  constants.friction = friction;
  constants.restitution = restitution;
  return constants;
}

/// A box of `material` on the surface of item or shape `index`.
PlacedItem box_on(Support support, double mass, const Vector3& size, const std::string& material) {
  PlacedItem item = blocks::block(mass, size, {}).items[0];
  item.name = "box " + material;
  item.model.material = material;
  item.on = support;
  return item;
}

/// A block of 40 kg, 1 m x 1 m x 0.5 m, and a box of 10 kg on it.
Scene box_on_block(double friction_below, double friction_between) {
  Scene scene = blocks::block(40, {1, 1, 0.5}, rough(friction_below));
  scene.items[0].name = "block";
  scene.items.push_back(box_on({Support::Kind::kItem, 0, 0.5}, 10, {0.2, 0.2, 0.2}, "rubber"));
  scene.pairs.push_back({"rubber", "steel", rough(friction_between)});
  scene.pairs.push_back({"rubber", "concrete", rough(0.5)});
  return scene;
}

TEST(SupportedItems, StayAtRest) {
  Scene scene = box_on_block(0.5, 0.5);
  scene.items.push_back(box_on({Support::Kind::kItem, 1, 0.7}, 2, {0.1, 0.1, 0.1}, "paper"));
  scene.pairs.push_back({"paper", "rubber", rough(0.5)});
  scene.pairs.push_back({"paper", "steel", rough(0.5)});
  scene.pairs.push_back({"paper", "concrete", rough(0.5)});
  EXPECT_TRUE(find_overlaps(scene).empty());
  const Response response = simulate(scene, {}, blocks::run_for(1, 0.004, 0.02));
  for (std::size_t i = 0; i < 3; ++i) {
    const Demands& d = response.items[i].demands;
    // The block settles by 50 kg g / (4 points 1e7 N/m) = 1e-5 m; nothing moves by a part of it.
    EXPECT_LT(d.peak_displacement, 1e-8) << i;
    EXPECT_NEAR(response.items[i].history.back().displacement.z(), 0, 1e-7) << i;
    EXPECT_EQ(d.impacts, 0) << i;
    EXPECT_EQ(d.time_of_fall, -1);
    EXPECT_EQ(std::isnan(d.peak_slide), i == 0);
  }
  EXPECT_LT(response.items[2].demands.peak_slide, 1e-8);
}

// With mu between them and none below, m2 on m1 that starts at v0 slips v0^2 / (2 mu g (1 + m2 / m1)), and both
// go on at m1 v0 / (m1 + m2). Friction is that of contacts with a tangential spring: what it holds in the end,
// mu g m2 / (4 k_t), is below 1e-6 m; 4 ms and the end of slip inside a step leave v0 h / 8, 2e-4 m at most.
TEST(SupportedItems, SlideAsABlockOnABlock) {
  Scene scene = box_on_block(0, 0.3);
  scene.items[0].initial.velocity = {0.5, 0, 0};
  const Response response = simulate(scene, {}, blocks::run_for(1, 0.004, 0.02));
  const double slip = 0.25 / (2 * 0.3 * kGravity * 1.25);
  EXPECT_NEAR(response.items[1].demands.peak_slide, slip, 2e-4);
  for (const ItemResponse& item : response.items)
    EXPECT_NEAR(item.history.back().velocity.x(), 0.4, 1e-4);
  EXPECT_EQ(response.items[1].demands.time_of_fall, -1);
}

// A box of b / h = 0.25 on a block tips over under 0.5 g and lies there: it topples, which is no overturning of the
// item below and ends no run. On the floor it overturns, at the same stop of 4 ms or one beside it, and the run ends.
TEST(SupportedItems, ToppleWhereOnTheFloorTheyOverturn) {
  Scene scene = blocks::block(400, {1, 1, 0.5}, rough(2));
  scene.items[0].name = "block";
  scene.items.push_back(box_on({Support::Kind::kItem, 0, 0.5}, 10, {0.1, 0.1, 0.4}, "rubber"));
  for (const char* other : {"steel", "concrete"})
    scene.pairs.push_back({"rubber", other, rough(2)});
  Eigen::Matrix3Xd push = Eigen::Matrix3Xd::Zero(3, 501);
  push.row(0).head(400).setConstant(0.5 * kGravity);
  const FloorMotion floor(0.001, push);
  SimulationSettings settings = blocks::run_for(2, 0.004, 0.02);
  settings.follow_overturning = false;
  const Response on = simulate(scene, floor, settings);
  EXPECT_EQ(on.outcome, Outcome::kStopped) << on.cause;
  EXPECT_EQ(on.end_time, 2);
  EXPECT_EQ(on.items[0].demands.time_of_overturning, -1);
  EXPECT_EQ(on.items[1].demands.time_of_overturning, -1);
  EXPECT_GT(on.items[1].demands.time_of_toppling, 0.2);
  // It strikes the block, which is one of its impacts and none of the block's.
  EXPECT_GT(on.items[1].demands.impacts, 0);
  EXPECT_EQ(on.items[0].demands.impacts, 0);
  EXPECT_NEAR(std::abs(on.items[1].demands.direction_of_overturning), std::numbers::pi, 0.01);
  scene.items.erase(scene.items.begin());
  scene.items[0].on.reset();
  const Response alone = simulate(scene, floor, settings);
  EXPECT_EQ(alone.outcome, Outcome::kOverturned) << alone.cause;
  EXPECT_EQ(alone.items[0].demands.time_of_toppling, -1);
  EXPECT_NEAR(alone.items[0].demands.time_of_overturning, on.items[1].demands.time_of_toppling,
              2 * settings.time_step);
}

// A spring that holds a trolley on a slope is stretched by m g sin / K from the start: nothing moves.
TEST(SupportedItems, RestOnASlopeInTheirSprings) {
  Scene scene = scene_of(small::trolley({0, 0, 0, 0}, small::bare_tread(1e5, 1e5)));
  scene.slope = 0.02;
  scene.items[0].fixture.guides[0] = {Guide::Kind::kSpring, 0, 5000, 20};
  const Response response = simulate(scene, {}, blocks::run_for(1, 0.004, 0.02));
  EXPECT_LT(response.items[0].demands.peak_displacement, 1e-6);
}

/// A table 0.8 m high with a box on it.
Scene box_on_table(double friction) {
  Scene scene = blocks::block(4, {0.2, 0.2, 0.1}, rough(0.5));
  scene.items[0].name = "box";
  scene.room.push_back(
      {"table", "wood", {0, 0, 0.4}, Quaternion::Identity(), RoomBox{{0.6, 0.6, 0.8}}});
  scene.pairs.push_back({"steel", "wood", rough(friction)});
  scene.items[0].on = Support{Support::Kind::kShape, 0, 0.8};
  return scene;
}

// Newmark's block: a floor that accelerates at a for T and then moves on leaves a slip of
// (a - mu g) a T^2 / (2 mu g).
TEST(SupportedItems, SlideOnATableAsNewmarksBlock) {
  const double a = 4, T = 0.2, mu = 0.2;
  Eigen::Matrix3Xd motion = Eigen::Matrix3Xd::Zero(3, 2001);
  for (int i = 0; i <= 200; ++i) motion(0, i) = a;
  const Response response =
      simulate(box_on_table(mu), FloorMotion(0.001, motion), blocks::run_for(1.5, 0.004, 0.02));
  // The motion falls linearly to zero within 1 ms after T: T + 0.5 ms.
  const double until = T + 0.0005;
  const double slip = (a - mu * kGravity) * a * until * until / (2 * mu * kGravity);
  EXPECT_NEAR(response.items[0].demands.peak_slide, slip, 4e-3 * slip);
  EXPECT_EQ(response.items[0].demands.time_of_fall, -1);
}

// Over the edge at v: when its centre has passed it, it falls 0.8 m and more than 2 g h turns into speed but for
// what its rotation takes; it meets the floor with a corner at no more than the speed of all of its energy.
TEST(SupportedItems, FallFromATable) {
  Scene scene = box_on_table(0);
  scene.items[0].initial.velocity = {2, 0, 0};
  const Response response = simulate(scene, {}, blocks::run_for(2, 0.004, 0.02));
  const Demands& d = response.items[0].demands;
  EXPECT_GT(d.time_of_fall, 0.3 / 2) << "its centre reaches the edge";
  EXPECT_LT(d.time_of_fall, 0.3 / 2 + 0.1 + std::sqrt(2 * 0.05 / kGravity)) << "free by then";
  EXPECT_GT(d.peak_slide, 0.3);
  ASSERT_GT(d.impacts, 0);
  const double height = 0.8 + 0.05;
  EXPECT_GT(d.largest_approach_speed, 0.9 * std::sqrt(2 * kGravity * (0.8 - 0.1)));
  EXPECT_LT(d.largest_approach_speed, std::sqrt(2 * kGravity * height + 4));
  EXPECT_LT(response.quality.energy_closure, 0.01);
}

// A tray that is not level keeps a box by friction until tan(angle) is mu: it slides with the trolley's tilt.
TEST(SupportedItems, RideOnATrolleyOnCasters) {
  Scene scene = scene_of({});
  scene.items[0].name = "trolley";
  EquipmentModel& trolley = scene.items[0].model = small::trolley({0, 0, 0, 0}, Tread{});
  double top = 0;
  for (const BodyShape& box : trolley.shape) top = std::max(top, box.center.z() + box.size.z() / 2);
  trolley.material = "steel";
  scene.floor_material = "concrete";
  scene.items.push_back(box_on({Support::Kind::kItem, 0, top}, 3, {0.1, 0.1, 0.1}, "rubber"));
  scene.pairs = {{"steel", "concrete", rough(0.5)},
                 {"rubber", "steel", rough(0.6)},
                 {"rubber", "concrete", rough(0.6)}};
  const FloorMotion floor = small::noise_record(3, 4, {1.5, 1.5, 0.5});
  const Response response = simulate(scene, floor, blocks::run_for(4, 0.004, 0.02));
  ASSERT_FALSE(is_failure(response.outcome)) << response.cause;
  EXPECT_GT(response.items[0].demands.peak_displacement, 0.02);
  EXPECT_LT(response.items[1].demands.peak_slide, 1e-4) << "rolling casters pass on less than mu g";
  EXPECT_NEAR(response.items[1].demands.peak_displacement,
              response.items[0].demands.peak_displacement, 1e-3);
  EXPECT_LT(response.quality.energy_closure, 0.01);
}

TEST(SupportedItems, RefusesWhatCannotStandThere) {
  const auto error_of = [](const Scene& scene) -> std::string {
    try {
      validate(scene);
      return "";
    } catch (const Error& error) {
      return error.what();
    }
  };
  Scene scene = box_on_block(0.5, 0.5);
  EXPECT_EQ(error_of(scene), "");
  scene.items[1].on->index = 1;
  EXPECT_THAT(error_of(scene), testing::HasSubstr("on.index = 1: must be of an item before it"));
  scene.items[1].on = Support{Support::Kind::kShape, 0, 0.5};
  EXPECT_THAT(error_of(scene), testing::HasSubstr("must be of a shape of the room"));
  scene.items[1].on = Support{Support::Kind::kItem, 0, -1};
  EXPECT_THAT(error_of(scene), testing::HasSubstr("on.height = -1"));
}

}  // namespace
}  // namespace gurney
