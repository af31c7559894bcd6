#include <gtest/gtest.h>

#include "tests/benchmark/crowd.h"
#include "tests/benchmark/regimes.h"

// A part of the table of rooms in docs/performance.md, which `./dev bench --rooms` makes.
namespace gurney::benchmark {
namespace {

TEST(Crowd, StandsFifteenCentimetresApart) {
  const Scene scene = crowd(5, 2);
  ASSERT_EQ(scene.items.size(), 10u);
  const Vector3 size = scene.items[0].model.shape[0].size;
  const auto gap = [&](std::size_t a, std::size_t b, int axis) {
    return scene.items[b].initial.position[axis] - scene.items[a].initial.position[axis] -
           size[axis];
  };
  EXPECT_NEAR(gap(0, 1, 0), 0.15, 1e-12);  // rounding
  EXPECT_NEAR(gap(3, 8, 1), 0.15, 1e-12);
  ASSERT_EQ(scene.room.size(), 4u);
  const auto& wall = scene.room[0];
  const double face = wall.position.x() - 0.5 * std::get<RoomBox>(wall.shape).size.x();
  EXPECT_NEAR(face - scene.items[4].initial.position.x() - 0.5 * size.x(), 0.15, 1e-12);
}

// Three of the five motions that settle within 1 %, with errors of 0.15, 0.47 and 0.15 %: room for
// what another compiler changes.
TEST(RoomsTable, SmoothImpactsSettle) {
  const Scene scene = crowd(1, 1);
  for (const int k : {0, 7, 10}) {
    const auto items = judged_items(scene, motion_of_regime(kRegimes[0], k, 12));
    ASSERT_EQ(items.size(), 1u);
    EXPECT_EQ(items[0].verdict, Predictability::Verdict::kPredictable) << k;
    EXPECT_LE(items[0].error, 0.01) << k;
  }
}

}  // namespace
}  // namespace gurney::benchmark
