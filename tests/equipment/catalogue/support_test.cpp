#include "equipment/catalogue/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/base/units.h"

namespace gurney::equipment {
namespace {

constexpr double kRounding = 1e-12;  // lengths below 1 m, a few operations each
constexpr double kTrail = 0.034;

Vector2 unit(double degrees) {
  return {std::cos(degrees * kRadiansPerDegree), std::sin(degrees * kRadiansPerDegree)};
}

double towards(const std::vector<Support>& supports, const Vector2& point, double degrees) {
  return reach_towards(supports, point, degrees * kRadiansPerDegree);
}

std::vector<Support> ring(int legs, double radius, double trail) {
  std::vector<Support> supports;
  for (int i = 0; i < legs; ++i) supports.push_back({radius * unit(360.0 * i / legs), trail});
  return supports;
}

const std::vector<Support> kRectangle = {
    {{0.3, 0.2}, 0}, {{0.3, -0.2}, 0}, {{-0.3, 0.2}, 0}, {{-0.3, -0.2}, 0}};

TEST(Support, ARectangleIsLeftOverTheEdgeThatTheWayMeetsFirst) {
  const Vector2 point(0.1, -0.05);
  for (double degrees = 3.75; degrees < 360; degrees += 7.5) {
    const Vector2 d = unit(degrees);
    const double along = d.x() > 0 ? (0.3 - point.x()) / d.x() : (-0.3 - point.x()) / d.x();
    const double across = d.y() > 0 ? (0.2 - point.y()) / d.y() : (-0.2 - point.y()) / d.y();
    EXPECT_NEAR(towards(kRectangle, point, degrees), std::min(along, across), kRounding) << degrees;
  }
}

TEST(Support, FiveLegsLoseTheTrailOfTheirApothem) {
  // Neighbours turned inwards leave an edge at 0.3 cos 36 deg - trail; towards a leg the way to
  // that edge is longer by 1 / cos 36 deg.
  const double cosine = std::cos(36 * kRadiansPerDegree);
  const auto star = ring(5, 0.3, kTrail);
  for (int i = 0; i < 5; ++i) {
    EXPECT_NEAR(towards(star, {0, 0}, 36 + 72 * i), 0.3 * cosine - kTrail, kRounding);
    EXPECT_NEAR(towards(star, {0, 0}, 72 * i), 0.3 - kTrail / cosine, kRounding);
  }
  EXPECT_NEAR(smallest_margin(star, {0, 0}).distance, 0.3 * cosine - kTrail, kRounding);
}

/// Way from `point` along `d` to where it leaves the triangle; the smaller of both ends if it is
/// not inside.
double way_out(const std::vector<Vector2>& corners, const Vector2& point, const Vector2& d) {
  double way = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector2 edge = corners[(i + 1) % 3] - corners[i];
    const Vector2 normal(edge.y(), -edge.x());  // outwards of an anticlockwise triangle
    if (normal.dot(d) > 0) way = std::min(way, normal.dot(corners[i] - point) / normal.dot(d));
  }
  return way;
}

TEST(Support, ThreeSwivelsAgreeWithASearchOverTheirAngles) {
  // Wheels every 6 degrees miss the innermost place by at most 0.05 m x (1 - cos 3 deg) = 6.9e-5 m
  // across an edge. No edge the point leaves over is inclined by more than 75 degrees to its way
  // (60 in the plain triangle and 15 for trails of 0.05 m on sides of 0.52 m, asin(0.1) twice at
  // most), so along the way that is below 6.9e-5 / cos 75 deg = 2.7e-4 m. The search is never
  // lower.
  std::vector<Support> supports = ring(3, 0.3, 0.05);
  supports[1].radius = 0.02;
  const auto corner = [&](int i, int step) {
    return Vector2(supports[i].center + supports[i].radius * unit(6.0 * step));
  };
  for (const double degrees : {0.0, 20.0, 60.0, 135.0, 250.0}) {
    const Vector2 d = unit(degrees);
    double smallest = 1;
    for (int a = 0; a < 60; ++a)
      for (int b = 0; b < 60; ++b)
        for (int c = 0; c < 60; ++c)
          smallest =
              std::min(smallest, way_out({corner(0, a), corner(1, b), corner(2, c)}, {0, 0}, d));
    const double exact = towards(supports, {0, 0}, degrees);
    EXPECT_GE(smallest, exact - kRounding) << degrees;
    EXPECT_LE(smallest, exact + 2.7e-4) << degrees;
  }
}

TEST(Support, TheSmallestWayIsTheSmallestMargin) {
  // Among directions every 15 degrees none is shorter than the margin; towards it they are equal.
  const auto star = ring(5, 0.3, kTrail);
  const Vector2 point(0.05, -0.08);
  const Margin margin = smallest_margin(star, point);
  EXPECT_NEAR(reach_towards(star, point, margin.direction), margin.distance, kRounding);
  for (int degrees = 0; degrees < 360; degrees += 15)
    EXPECT_GE(towards(star, point, degrees), margin.distance - kRounding);
}

TEST(Support, OneAndTwoWheelsEndAtTheWheel) {
  const std::vector<Support> one = {{{0.1, 0}, 0}}, two = {{{0.1, 0}, 0}, {{-0.1, 0}, 0}};
  EXPECT_NEAR(towards(one, {0.1, 0}, 0), 0, kRounding);
  EXPECT_NEAR(towards(two, {0, 0}, 0), 0.1, kRounding);
  EXPECT_NEAR(towards(two, {0, 0}, 90), 0, kRounding);
}

}  // namespace
}  // namespace gurney::equipment
