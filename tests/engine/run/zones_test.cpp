#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/run/overlaps.h"
#include "engine/run/simulate.h"
#include "studies/verification/scenes/blocks.h"

namespace gurney {
namespace {

constexpr double kPi = std::numbers::pi;

/// A block 0.4 m long and 0.3 m wide that slides along x, at first 1 m before the zone's middle.
Scene sliding(double speed, double y, double yaw = 0) {
  Scene scene = blocks::block(50, {0.4, 0.3, 0.5}, {.friction = 0});
  scene.items[0].initial.position = {-1, y, 0};
  scene.items[0].initial.velocity = {speed, 0, 0};
  scene.items[0].initial.yaw = yaw;
  scene.zones = {{.name = "lane", .center = {0, 0}, .length = 0.6, .width = 1.2}};
  return scene;
}

TEST(Zones, TellWhenAnItemEntersHowLongItStaysAndWhatItLeavesFree) {
  const ZoneOutcome zone = simulate(sliding(1, 0.2), {}, blocks::run_for(2, 0.004, 0)).zones.at(0);
  // Its front enters at 1 - 0.2 - 0.3 s, its rear leaves at 1 + 0.2 + 0.3 s; both to a step.
  EXPECT_NEAR(zone.time_of_entry, 0.5, 0.005);
  EXPECT_NEAR(zone.occupied_time, 1.0, 0.009);
  EXPECT_FALSE(zone.occupied_at_end);
  EXPECT_NEAR(zone.least_free_width, 0.6 + 0.2 - 0.15, 1e-9);
  EXPECT_EQ(zone.free_width_at_end, 1.2);
}

TEST(Zones, TellWhatStandsInThemAtTheEnd) {
  const ZoneOutcome zone = simulate(sliding(1, 0.2), {}, blocks::run_for(1, 0.004, 0)).zones.at(0);
  EXPECT_TRUE(zone.occupied_at_end);
  EXPECT_NEAR(zone.free_width_at_end, 0.6 + 0.2 - 0.15, 1e-9);
}

// No corner of the block is in it.
TEST(Zones, AnItemLongerThanAZoneStandsInIt) {
  Scene scene = sliding(0, 0.2);
  scene.items[0].initial.position.x() = 0;
  scene.zones[0].length = 0.1;
  const ZoneOutcome zone = simulate(scene, {}, blocks::run_for(0.1, 0.004, 0)).zones.at(0);
  EXPECT_TRUE(zone.occupied_at_end);
  EXPECT_NEAR(zone.free_width_at_end, 0.6 + 0.2 - 0.15, 1e-9);
}

TEST(Zones, AnItemBesideThemDoesNotCount) {
  const ZoneOutcome zone = simulate(sliding(1, 0.76), {}, blocks::run_for(2, 0.004, 0)).zones.at(0);
  EXPECT_LT(zone.time_of_entry, 0);
  EXPECT_EQ(zone.occupied_time, 0);
  EXPECT_EQ(zone.least_free_width, 1.2);
}

// Turned by 45 degrees, the block's outline is (0.4 + 0.3) / sqrt 2 wide. The zone turned by 90
// degrees has its width along x.
TEST(Zones, TurnWithTheirAngleAndSeeTurnedItems) {
  Scene scene = sliding(0, 0, kPi / 4);
  scene.items[0].initial.position = {0, 0, 0};
  scene.zones[0].angle = kPi / 2;
  const ZoneOutcome zone = simulate(scene, {}, blocks::run_for(0.1, 0.004, 0)).zones.at(0);
  EXPECT_TRUE(zone.occupied_at_end);
  EXPECT_NEAR(zone.free_width_at_end, 0.5 * (1.2 - 0.7 / std::sqrt(2.0)), 1e-6);
}

TEST(Zones, TheWidestOfSeveralWaysCounts) {
  Scene scene = sliding(0, 0);
  scene.items[0].initial.position = {0, -0.3, 0};
  scene.items[0].name = "a";
  scene.items.push_back(scene.items[0]);
  scene.items[1].name = "b";
  scene.items[1].initial.position = {0.1, 0.35, 0};
  scene.pairs.push_back({"steel", "steel", {}});
  const ZoneOutcome zone = simulate(scene, {}, blocks::run_for(0.1, 0.004, 0)).zones.at(0);
  EXPECT_NEAR(zone.free_width_at_end, (0.35 - 0.15) - (-0.3 + 0.15), 1e-6);
}

TEST(FindOverlaps, NamesItemsInWallsAndInEachOther) {
  Scene scene = blocks::block(50, {0.4, 0.3, 0.5}, {});
  blocks::add_wall(scene, 0.17, {});
  scene.pairs.push_back({"steel", "steel", {}});
  scene.items[0].name = "a";
  scene.items.push_back(scene.items[0]);
  scene.items[1].name = "b";
  scene.items[1].initial.position = {-0.395, 0, 0};
  scene.items.push_back(scene.items[0]);
  scene.items[2].name = "c";
  scene.items[2].initial.position = {-3, 0, 0};
  const std::vector<Overlap> overlaps = find_overlaps(scene);
  ASSERT_EQ(overlaps.size(), 2u);
  for (const Overlap& overlap : overlaps) {
    EXPECT_EQ(overlap.item, 0u);
    // Bullet rounds corners by its margins of 1 mm.
    const double expected = overlap.shape == 0 ? 0.03 : 0.005;
    EXPECT_NEAR(overlap.depth, expected, 2e-3);
  }
  EXPECT_NE(overlaps[0].shape, overlaps[1].shape);
}

}  // namespace
}  // namespace gurney
