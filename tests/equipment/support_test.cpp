#include "equipment/support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace gurney {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kRounding = 1e-12;

std::vector<Support> rectangle(double a, double b, double radius = 0) {
  return {{{a, b}, radius}, {{a, -b}, radius}, {{-a, b}, radius}, {{-a, -b}, radius}};
}

TEST(Support, ReachOfARectangleEndsAtItsSides) {
  const auto supports = rectangle(0.4, 0.2);
  // From the middle along (cos t, sin t): min(a / |cos t|, b / |sin t|).
  for (int degrees = 0; degrees < 360; degrees += 7) {
    const double t = degrees * kPi / 180;
    EXPECT_NEAR(reach_towards(supports, {0, 0}, t),
                std::min(0.4 / std::abs(std::cos(t)), 0.2 / std::abs(std::sin(t))), kRounding)
        << degrees;
  }
  EXPECT_NEAR(reach_towards(supports, {0.1, 0.05}, 0), 0.3, kRounding);
  EXPECT_NEAR(reach_towards(supports, {0.1, 0.05}, kPi), 0.5, kRounding);
}

TEST(Support, FreeSwivelsDrawEverySideInByTheTrail) {
  const auto supports = rectangle(0.4, 0.2, 0.03);
  EXPECT_NEAR(reach_towards(supports, {0, 0}, 0), 0.37, kRounding);
  EXPECT_NEAR(reach_towards(supports, {0, 0}, kPi / 2), 0.17, kRounding);
  EXPECT_NEAR(smallest_margin(supports, {0, 0}).distance, 0.17, kRounding);
}

TEST(Support, ReachIsFoundBySearchOverManyEdges) {
  // Five legs, one of them rigid. The definition itself, over 360,000 edges: each misses the best
  // one by less than 1e-5 rad, which changes margin / cos by less than 2e-5 m here.
  std::vector<Support> supports;
  for (int i = 0; i < 5; ++i) {
    const double t = 2 * kPi * i / 5;
    supports.push_back({{0.3 * std::cos(t), 0.3 * std::sin(t)}, i == 2 ? 0 : 0.02});
  }
  const Vector2 point(0.03, -0.05);
  for (const double direction : {0.1, 1.3, 2.9, 4.4}) {
    double smallest = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 360000; ++k) {
      const double t = 2 * kPi * k / 360000;
      const Vector2 m(std::cos(t), std::sin(t));
      const double cosine = std::cos(t - direction);
      if (cosine < 1e-3) continue;
      double reach = -1;
      for (const Support& s : supports) reach = std::max(reach, s.center.dot(m) - s.radius);
      smallest = std::min(smallest, (reach - point.dot(m)) / cosine);
    }
    EXPECT_NEAR(reach_towards(supports, point, direction), smallest, 2e-5) << direction;
    EXPECT_LE(reach_towards(supports, point, direction), smallest + kRounding);
  }
}

TEST(Support, APointOutsideHasNegativeReachTowardsTheNearSide) {
  EXPECT_NEAR(reach_towards(rectangle(0.4, 0.2), {0.5, 0}, 0), -0.1, kRounding);
}

TEST(Support, HullLeavesOutWhatLiesInside) {
  auto supports = rectangle(0.4, 0.2);
  supports.push_back({{0.1, 0.1}, 0});
  supports.push_back({{0.4, 0}, 0});  // on an edge
  const auto hull = hull_of(supports);
  ASSERT_EQ(hull.size(), 4u);
  double twice_area = 0;  // positive: anticlockwise
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vector2 &a = hull[i], &b = hull[(i + 1) % hull.size()];
    twice_area += a.x() * b.y() - a.y() * b.x();
  }
  EXPECT_NEAR(twice_area, 2 * 0.8 * 0.4, kRounding);
}

}  // namespace
}  // namespace gurney
