#include "engine/record/zone_log.h"

#include <gtest/gtest.h>

#include <numbers>

#include "studies/verification/scenes/blocks.h"

// A block of 0.5 x 0.4 m is moved by hand past a zone that is 2 m along x and 1 m across.
namespace gurney {
namespace {

Scene scene_with(const Zone& zone) {
  Scene scene = blocks::block(10, {0.5, 0.4, 0.6}, {});
  scene.zones = {zone};
  return scene;
}

const Zone kWay{.name = "way", .center = {3, 0}, .length = 2, .width = 1, .angle = 0};

class Watched {
 public:
  explicit Watched(const Zone& zone)
      : scene_(scene_with(zone)), assembly_(scene_), log_(scene_, assembly_) {
    state_.items.resize(1);
  }

  void see(double time, double x, double y, double yaw = 0) {
    state_.items[0].position = {x, y, 0.3};
    state_.items[0].rotation = Quaternion(Eigen::AngleAxisd(yaw, Vector3::UnitZ()));
    log_.observe(time, time - before_, state_);
    before_ = time;
  }
  const ZoneOutcome& outcome() const { return log_.outcomes().at(0); }

 private:
  Scene scene_;
  Assembly assembly_;
  ZoneLog log_;
  SceneState state_;
  double before_ = 0;
};

TEST(ZoneLog, AnItemThatStaysOutsideLeavesAllOfIt) {
  Watched watched(kWay);
  watched.see(0, 0, 0);
  watched.see(1, 1.74, 0);   // its front is 10 mm before the zone
  watched.see(2, 3, 0.701);  // its side 1 mm beside it
  EXPECT_EQ(watched.outcome().time_of_entry, -1);
  EXPECT_EQ(watched.outcome().occupied_time, 0);
  EXPECT_EQ(watched.outcome().least_free_width, 1);
  EXPECT_FALSE(watched.outcome().occupied_at_end);
}

TEST(ZoneLog, CountsTheTimeFromTheFirstEntryAndEachOneAfterIt) {
  Watched watched(kWay);
  watched.see(0, 0, 0);
  watched.see(0.5, 1.76, 0);
  EXPECT_TRUE(watched.outcome().occupied_at_end);
  watched.see(0.75, 1, 0);
  EXPECT_FALSE(watched.outcome().occupied_at_end);
  watched.see(1.75, 3, 0);
  watched.see(2, 9, 0);
  EXPECT_EQ(watched.outcome().time_of_entry, 0.5);
  EXPECT_EQ(watched.outcome().occupied_time, 0.5 + 1);
  EXPECT_FALSE(watched.outcome().occupied_at_end);
}

// 0.4 m wide and 0.1 m off the middle: 0.4 m are free on one side and 0.2 m on the other.
TEST(ZoneLog, KeepsTheWidestStripBesideTheItem) {
  Watched watched(kWay);
  watched.see(0, 3, 0.1);
  EXPECT_NEAR(watched.outcome().free_width_at_end, 0.4, 1e-15);
  watched.see(1, 3, 0.3);
  EXPECT_NEAR(watched.outcome().free_width_at_end, 0.6, 1e-15);
  EXPECT_NEAR(watched.outcome().least_free_width, 0.4, 1e-15);
  watched.see(2, 3, 0, std::numbers::pi / 2);  // 0.5 m across
  EXPECT_NEAR(watched.outcome().least_free_width, 0.25, 1e-15);
}

// Turned by 45 degrees, of the diagonal only the tip is inside: at x = 2 + s it is 2 s wide.
TEST(ZoneLog, TakesOnlyWhatIsInsideOfAnItemThatReachesIn) {
  constexpr double kHalfDiagonal = (0.25 + 0.2) / std::numbers::sqrt2;  // along x, at 45 degrees
  Watched watched(kWay);
  watched.see(0, 2.1 - kHalfDiagonal, 0, std::numbers::pi / 4);
  const double tip = 0.05 / std::numbers::sqrt2;  // of the leading corner, across
  EXPECT_NEAR(watched.outcome().free_width_at_end, 0.5 + tip - 0.1, 1e-12);
}

// The same positions seen from a zone that is turned by 90 degrees about the origin.
TEST(ZoneLog, TurnsWithItsAngle) {
  Zone up = kWay;
  up.center = {0, 3};
  up.angle = std::numbers::pi / 2;
  Watched watched(up);
  watched.see(0, 0, 1.74, std::numbers::pi / 2);
  EXPECT_FALSE(watched.outcome().occupied_at_end);
  watched.see(1, -0.1, 3, std::numbers::pi / 2);
  EXPECT_EQ(watched.outcome().time_of_entry, 1);
  EXPECT_NEAR(watched.outcome().free_width_at_end, 0.4, 1e-12);
}

}  // namespace
}  // namespace gurney
