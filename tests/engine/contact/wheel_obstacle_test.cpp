#include "engine/contact/wheel_obstacle.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

// A kerb 20 mm high with its edge along y at x = 0, met by round bodies from guessed normals.
namespace gurney {
namespace {

constexpr double kHeight = 0.02;
const WheelObstacle& kerb() {
  static const WheelObstacle shape(convex_box({0.5, 0, 0.5 * kHeight}, {1, 2, kHeight}));
  return shape;
}

WheelObstacle::Lowest ball(const Vector3& center, double radius) {
  return [=](const Vector3& normal) -> Vector3 { return center - radius * normal; };
}

Vector3 turned(const Vector3& v, double angle, const Vector3& axis) {
  return Eigen::AngleAxisd(angle, axis) * v;
}

// The sum of 40 halvings of at most 180 degrees leaves 3e-12 rad.
constexpr double kExact = 1e-11;

TEST(WheelObstacle, NormalAtAnEdgeIsExactFromAGuess) {
  constexpr double kRadius = 0.05;
  const Vector3 edge(0, 0, kHeight);
  for (double rise : {0.2, 0.7, 1.3})         // of the centre from the edge [rad]
    for (double gap : {0.01, 0.0, -0.005})    // [m]
      for (double off : {-0.3, -0.01, 0.02})  // of the guess [rad]
      {
        const Vector3 normal(-std::cos(rise), 0, std::sin(rise));
        const Vector3 center = edge + (kRadius + gap) * normal;
        const Vector3 guess = turned(normal, off, Vector3(0.6, 0.8, 0));
        const auto plane = kerb().between(guess, ball(center, kRadius));
        EXPECT_LT((plane.normal - normal).norm(), kExact) << rise << ", " << gap << ", " << off;
        EXPECT_NEAR(plane.offset, normal.dot(edge), kExact);
      }
}

TEST(WheelObstacle, NormalAtAFaceIsItsOwn) {
  const auto wall = kerb().between(turned(-Vector3::UnitX(), 0.02, Vector3::UnitY()),
                                   ball({-0.049, 0.3, 0.01}, 0.05));
  EXPECT_LT((wall.normal + Vector3::UnitX()).norm(), kExact);
  EXPECT_NEAR(wall.offset, 0, kExact);
  const auto top = kerb().between(turned(Vector3::UnitZ(), -0.02, Vector3::UnitY()),
                                  ball({0.001, 0.3, 0.07}, 0.05));
  EXPECT_LT((top.normal - Vector3::UnitZ()).norm(), kExact);
  EXPECT_NEAR(top.offset, kHeight, kExact);
}

// A thin disc whose axle is 0.5 rad off the edge: no normal between the faces leaves more.
TEST(WheelObstacle, ADiscAcrossMeetsTheEdgeWhereItIsApartMost) {
  const Vector3 axle(std::sin(0.5), std::cos(0.5), 0), center(-0.03, 0.1, 0.05);
  const WheelObstacle::Lowest disc = [&](const Vector3& normal) -> Vector3 {
    return center - 0.05 * (normal - normal.dot(axle) * axle).normalized();
  };
  const auto gap = [&](const Vector3& normal) {
    return normal.dot(disc(normal) - Vector3(0, 0, kHeight));
  };
  const auto plane = kerb().between(Vector3(-0.75, 0.01, 0.66).normalized(), disc);
  double widest = -1;
  for (int i = 0; i <= 1000; ++i) {
    const double rise = i * M_PI / 2000;
    widest = std::max(widest, gap({-std::cos(rise), 0, std::sin(rise)}));
  }
  EXPECT_GE(gap(plane.normal), widest);
  // Half of the spacing from the best of them: 0.1 m (pi / 4000)^2 / 2.
  EXPECT_LT(gap(plane.normal), widest + 1e-7);
  EXPECT_NEAR(plane.normal.y(), 0, kExact);
}

TEST(WheelObstacle, AtACornerTheGuessStays) {
  const Vector3 corner(0, 1, kHeight), normal = Vector3(-1, 1, 1).normalized();
  const auto plane = kerb().between(normal, ball(corner + 0.05 * normal, 0.05));
  EXPECT_LT((plane.normal - normal).norm(), kExact);
  EXPECT_NEAR(plane.offset, normal.dot(corner), kExact);
}

// The kerb reaches from x = 0 to 1 and from y = -1 to 1.
TEST(WheelObstacle, AFaceIsFacedOnlyByWhatIsBeforeOrBehindIt) {
  const Vector3 up = Vector3::UnitZ();
  EXPECT_TRUE(kerb().faces(up, {0.5, 0, kHeight + 0.01}));
  EXPECT_TRUE(kerb().faces(up, {0.01, 0.99, 0.5 * kHeight}));
  EXPECT_FALSE(kerb().faces(up, {-0.01, 0, kHeight})) << "beside it";
  EXPECT_FALSE(kerb().faces(up, {0.5, 1.01, kHeight}));
  EXPECT_FALSE(kerb().faces(Vector3(-0.6, 0, 0.8), {0.01, 0, kHeight})) << "an edge is no face";
}

}  // namespace
}  // namespace gurney
