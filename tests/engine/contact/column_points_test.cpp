#include "engine/contact/column_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

// A box that faces a cylinder: which points, which normal, which gap.
namespace gurney {
namespace {

constexpr double kMargin = 0.02, kRadius = 0.15;
const Vector3 kStill = Vector3::Zero();

Cylinder upright(double height = 3) {
  return {{0, 0, 0.5 * height}, Vector3::UnitZ(), kRadius, 0.5 * height};
}

std::vector<FacingPoint> between(const ConvexShape& a, const Cylinder& b) {
  std::vector<FacingPoint> points;
  column_points(a, b, kStill, kMargin, points);
  return points;
}

TEST(ColumnPoints, AFaceTouchesAlongALine) {
  for (double height : {3.0, 0.4})
    for (double gap : {0.019, 1e-6, 0.0, -1e-6, -0.003}) {
      const auto box = convex_box({-0.25 - kRadius - gap, 0.05, 0.3}, {0.5, 0.4, 0.6});
      const auto points = between(box, upright(height));
      ASSERT_EQ(points.size(), 2u) << height << ", " << gap;
      const double top = std::min(0.6, height);
      EXPECT_NEAR(std::min(points[0].on_a.z(), points[1].on_a.z()), 0, 1e-12);
      EXPECT_NEAR(std::max(points[0].on_a.z(), points[1].on_a.z()), top, 1e-12);
      for (const FacingPoint& p : points) {
        EXPECT_NEAR(p.gap, gap, 1e-12);
        EXPECT_NEAR(p.on_a.y(), 0, 1e-12) << "the line that faces it";
        EXPECT_NEAR((p.normal + Vector3::UnitX()).norm(), 0, 1e-12);
      }
    }
}

TEST(ColumnPoints, AnEdgeTouchesAwayFromTheAxis) {
  const Quaternion turn(Eigen::AngleAxisd(std::numbers::pi / 4, Vector3::UnitZ()));
  const double half = 0.2, diagonal = half * std::numbers::sqrt2;
  for (double angle : {std::numbers::pi, 2.8, -2.6})
    for (double gap : {0.01, -0.001}) {
      const Vector3 normal(std::cos(angle), std::sin(angle), 0);
      const Vector3 edge = (kRadius + gap) * normal;  // at the +x end of the turned box
      const auto box = convex_box(kStill, {2 * half, 2 * half, 0.6})
                           .placed(turn, edge + Vector3(-diagonal, 0, 0.3));
      const auto points = between(box, upright());
      ASSERT_EQ(points.size(), 2u) << angle << ", " << gap;
      for (const FacingPoint& p : points) {
        EXPECT_NEAR(p.gap, gap, 1e-9);
        EXPECT_NEAR((p.normal - normal).norm(), 0, 1e-9);
        EXPECT_NEAR((p.on_a - edge).head<2>().norm(), 0, 1e-12);
        EXPECT_NEAR(p.on_b.head<2>().norm(), kRadius, 1e-12);
      }
      EXPECT_NEAR(std::abs(points[0].on_a.z() - points[1].on_a.z()), 0.6, 1e-12);
    }
}

TEST(ColumnPoints, ALeaningEdgeTouchesWhereItIsNearest) {
  // The box's edge leans by 0.2 rad across the line of sight: nearest at z = 0.6.
  const Quaternion lean(Eigen::AngleAxisd(0.2, Vector3::UnitX()));
  const Quaternion turn(Eigen::AngleAxisd(-std::numbers::pi / 4, Vector3::UnitZ()));
  const double gap = 0.004;
  const Vector3 nearest_point(-kRadius - gap, 0, 0.6);
  // Before it is turned, its edge along z at the origin looks along x and y alike.
  const auto placed =
      convex_box({-0.2, -0.2, 0}, {0.4, 0.4, 0.6}).placed(turn, kStill).placed(lean, nearest_point);
  const auto points = between(placed, upright());
  ASSERT_FALSE(points.empty());
  const auto nearest =
      std::min_element(points.begin(), points.end(),
                       [](const FacingPoint& p, const FacingPoint& q) { return p.gap < q.gap; });
  EXPECT_NEAR(nearest->gap, gap, 1e-12);
  EXPECT_NEAR((nearest->on_a - nearest_point).norm(), 0, 1e-9);
}

TEST(ColumnPoints, WhatStandsOnAnEndHasItsPoints) {
  const auto box = convex_box({0, 0, 0.5 + 0.3 - 0.001}, {1, 1, 0.6});
  const auto points = between(box, upright(0.5));
  ASSERT_EQ(points.size(), 16u);
  for (const FacingPoint& p : points) {
    EXPECT_NEAR(p.gap, -0.001, 1e-12);
    EXPECT_NEAR((p.normal - Vector3::UnitZ()).norm(), 0, 1e-12);
    EXPECT_NEAR(p.on_b.head<2>().norm(), kRadius, 1e-12);
  }
}

TEST(ColumnPoints, BeyondTheMarginThereIsNothing) {
  EXPECT_TRUE(
      between(convex_box({-0.25 - kRadius - 0.0201, 0, 0.3}, {0.5, 0.4, 0.6}), upright()).empty());
  EXPECT_TRUE(
      between(convex_box({-0.25 - kRadius - 0.001, 0.5, 0.3}, {0.5, 0.4, 0.6}), upright()).empty());
}

}  // namespace
}  // namespace gurney
