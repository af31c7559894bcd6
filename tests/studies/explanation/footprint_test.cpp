#include "studies/explanation/footprint.h"

#include <gtest/gtest.h>

#include <numbers>

namespace gurney::explanation {
namespace {

/// Extent of a polygon along x and y.
std::pair<Vector2, Vector2> bounds(const Polygon& polygon) {
  Vector2 low = polygon[0], high = polygon[0];
  for (const Vector2& p : polygon) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return {low, high};
}

TEST(Footprint, ShowsWhereAnItemLies) {
  PlacedItem item;
  item.model.shape = {{{0, 0, 0.9}, {0.4, 0.6, 1.8}}};
  item.initial.position = {1, 2, 0};
  Sample sample;
  EXPECT_TRUE(bounds(footprint(item, sample)[0]).first.isApprox(Vector2(0.8, 1.7)));
  // Over its front edge: the origin, below the middle, is 0.2 m above the floor behind the edge.
  sample.displacement = {0.2, 0, 0.2};
  sample.orientation = Eigen::AngleAxisd(std::numbers::pi / 2, Vector3::UnitY());
  const auto [low, high] = bounds(footprint(item, sample)[0]);
  EXPECT_TRUE(low.isApprox(Vector2(1.2, 1.7), 1e-9)) << low;
  EXPECT_TRUE(high.isApprox(Vector2(3.0, 2.3), 1e-9)) << high;
}

TEST(Footprint, KnowsEveryShapeOfARoom) {
  RoomShape shape{"s", "", {1, 0, 1}, Quaternion::Identity(), RoomBox{{2, 1, 2}}};
  EXPECT_TRUE(bounds(footprint(shape)).second.isApprox(Vector2(2, 0.5)));
  shape.shape = RoomColumn{0.3, 2};
  EXPECT_TRUE(bounds(footprint(shape)).second.isApprox(Vector2(1.3, 0.3), 1e-9));
  shape.shape = RoomHull{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  EXPECT_EQ(footprint(shape).size(), 3u);
  shape.rotation = Eigen::AngleAxisd(std::numbers::pi / 2, Vector3::UnitZ());
  EXPECT_TRUE(bounds(footprint(shape)).first.isApprox(Vector2(0, 0), 1e-9) ||
              bounds(footprint(shape)).first.x() < 1e-9);
}

TEST(Overlap, IsOfAreasNotOfEdges) {
  const Polygon square = footprint(Zone{"z", {0, 0}, 2, 2, 0});
  EXPECT_TRUE(overlap(square, footprint(Zone{"z", {1.5, 0}, 2, 2, 0})));
  EXPECT_FALSE(overlap(square, footprint(Zone{"z", {2.1, 0}, 2, 2, 0})));
  // Turned by 45 degrees a square reaches sqrt(2) along its diagonal.
  EXPECT_TRUE(overlap(square, footprint(Zone{"z", {2.4, 0}, 2, 2, std::numbers::pi / 4})));
  EXPECT_FALSE(overlap(square, footprint(Zone{"z", {1.9, 1.9}, 2, 1, -std::numbers::pi / 4})));
}

}  // namespace
}  // namespace gurney::explanation
