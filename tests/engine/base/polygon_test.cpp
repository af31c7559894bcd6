#include "engine/base/polygon.h"

#include <gtest/gtest.h>

namespace gurney {
namespace {

TEST(ConvexPolygon, GoesAroundAndLeavesOutWhatLiesInsideOrOnAnEdge) {
  const Polygon corners = {{-0.3, -0.2}, {0.3, -0.2}, {0.3, 0.2}, {-0.3, 0.2}};
  Polygon points = corners;
  std::swap(points[0], points[2]);
  points.emplace_back(0, 0);
  points.emplace_back(0, 0.2);
  EXPECT_EQ(convex_polygon(points), corners);
}

TEST(ConvexPolygon, OfFewerThanThreePointsIsThese) {
  EXPECT_EQ(convex_polygon({{0, 0}, {1, 1}}).size(), 2u);
}

}  // namespace
}  // namespace gurney
