#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "engine/contact/body_form.h"

// Contacts of round bodies against the distance of convex bodies by another way.
namespace gurney {
namespace {

double gap_along(const BodyForm& a, const BodyForm& b, const Vector3& normal) {
  return lowest(a, normal) + lowest(b, -normal);
}

/// How far a point is outside of a form at least; 0: not.
double outside(const BodyForm& form, const Vector3& point) {
  if (const auto* sphere = std::get_if<Sphere>(&form))
    return std::max(0.0, (point - sphere->center).norm() - sphere->radius);
  if (const auto* column = std::get_if<Cylinder>(&form)) {
    const Vector3 from = point - column->center;
    return std::max({0.0, std::abs(column->axis.dot(from)) - column->half_height,
                     column->across(from).norm() - column->radius});
  }
  double out = 0;
  const auto& solid = std::get<ConvexShape>(form);
  for (const ConvexShape::Face& face : solid.faces)
    out = std::max(out, face.normal.dot(point) - solid.level(face));
  return out;
}

double uniform(std::mt19937& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

BodyForm placed(const BodyShape& shape, const Quaternion& rotation, const Vector3& position) {
  const BodyForm form = body_form(shape, Vector3::Zero());
  BodyForm result = form;
  place(form, rotation, position, result);
  return result;
}

/// The point with the least gap; where none is found, at a gap of 10 m.
FacingPoint nearest_point(const BodyForm& a, const BodyForm& b) {
  std::vector<FacingPoint> points;
  form_points(a, b, Vector3::Zero(), 1, points);
  if (points.empty()) return {Vector3::Zero(), Vector3::Zero(), Vector3::UnitZ(), 10};
  return *std::ranges::min_element(points, {}, &FacingPoint::gap);
}

const BodyShape kBox{{0, 0, 0}, {0.3, 0.2, 0.5}};
const BodyShape kSphere = sphere_shape({0, 0, 0}, 0.12);
const BodyShape kCylinder = cylinder_shape({0, 0, 0}, {Vector3::UnitZ(), 0.1, 0.4});
const BodyShape kHull =
    hull_shape({{-0.2, -0.2, -0.1}, {0.3, -0.1, -0.1}, {0, 0.25, -0.1}, {0.05, 0, 0.3}});

// A solid and a cylinder have the same points whichever comes first, where they approach and where
// they part: along which of several axes they meet depends on the motion.
TEST(RoundPoints, AreTheSameWhicheverBodyIsNamedFirst) {
  std::mt19937 random(3);
  const auto vector = [&](double size) {
    return Vector3(uniform(random, -size, size), uniform(random, -size, size),
                   uniform(random, -size, size));
  };
  const auto gaps = [](const BodyForm& a, const BodyForm& b, const Vector3& motion) {
    std::vector<FacingPoint> points;
    form_points(a, b, motion, 0.3, points);
    std::vector<double> all;
    for (const FacingPoint& point : points) all.push_back(point.gap);
    return all;
  };
  int by_motion = 0;
  for (int i = 0; i < 300; ++i) {
    const auto turned = [&] { return Quaternion(1, 0, 0, 0.3) * Quaternion(1, 0.2, 0.1, 0); };
    const BodyForm box = placed(kBox, turned().normalized(), vector(0.4));
    const BodyForm column = placed(kCylinder, Quaternion::Identity(), vector(0.4));
    const Vector3 motion = vector(0.3);
    const std::vector<double> solid_first = gaps(box, column, motion);
    ASSERT_EQ(solid_first, gaps(column, box, -motion)) << i;
    by_motion += solid_first != gaps(box, column, -motion);
  }
  EXPECT_GT(by_motion, 10);
}

// Two points of two convex bodies are at least as far apart as these are, and a plane between them leaves no
// more than that: where the points that are found are as far apart as the plane across them leaves, they are
// the distance. Of spheres always; of cylinders exactly where sides, ends and corners are nearest, and where
// rims are, to the r (1 - cos(pi / 32)) = 0.5 mm of each prism. Polyhedra and cylinders that are nearest corner
// to corner have no axis of the search between them: nothing is found until they come nearer, to 2 mm here.
TEST(RoundPoints, AreAsFarApartAsAPlaneBetweenLeaves) {
  std::mt19937 random(7);
  struct Pair {
    const BodyShape &a, &b;
    bool exact;
  };
  for (const Pair& pair : {Pair{kSphere, kBox, true}, Pair{kSphere, kHull, true},
                           Pair{kSphere, kCylinder, true}, Pair{kSphere, kSphere, true},
                           Pair{kCylinder, kBox, false}, Pair{kCylinder, kCylinder, false}}) {
    int apart = 0, exactly = 0;
    for (int i = 0; i < 300; ++i) {
      const auto turned = [&] {
        return Quaternion(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1),
                          uniform(random, -1, 1))
            .normalized();
      };
      Vector3 away(uniform(random, -0.6, 0.6), uniform(random, -0.6, 0.6),
                   uniform(random, -0.6, 0.6));
      const Quaternion of_a = turned();
      const BodyForm b = placed(pair.b, turned(), {0, 0, 0});
      BodyForm a = placed(pair.a, of_a, away);
      FacingPoint found = nearest_point(a, b);
      for (int nearer = 0; nearer < 5 && !pair.exact && found.gap < 10; ++nearer) {
        away -= (found.gap - 2e-3) * found.normal;
        a = placed(pair.a, of_a, away);
        found = nearest_point(a, b);
      }
      if (found.gap < 1e-3 || found.gap == 10) continue;
      ++apart;
      ASSERT_LT(outside(a, found.on_a), 1e-9);
      ASSERT_LT(outside(b, found.on_b), 1e-9);
      const double leaves = gap_along(a, b, found.normal);
      if (pair.exact) {
        ASSERT_NEAR(leaves, found.gap, 1e-12);
        ASSERT_NEAR((found.on_a - found.on_b).norm(), found.gap, 1e-12);
      }
      ASSERT_NEAR(leaves, found.gap, 1e-3) << i;
      exactly += std::abs(leaves - (found.on_a - found.on_b).norm()) < 1e-9;
    }
    EXPECT_GT(apart, 100);
    EXPECT_GT(exactly, 20);
  }
}

TEST(RoundPoints, AStandingCylinderKeepsItsPointsAndATiltedOneRolls) {
  const BodyForm table =
      placed({{0, 0, -0.1}, {1, 1, 0.2}}, Quaternion::Identity(), Vector3::Zero());
  const auto points = [&](double tilt) {
    const Quaternion turn(Eigen::AngleAxisd(tilt, Vector3(1, 0.3, 0).normalized()));
    std::vector<FacingPoint> found;
    form_points(table, placed(kCylinder, turn, {0.1, 0, 0.22}), Vector3::Zero(), 0.2, found);
    return found;
  };
  const std::vector<FacingPoint> upright = points(0);
  EXPECT_EQ(upright.size(), Cylinder::kRimPoints);
  for (const FacingPoint& point : upright) {
    EXPECT_FALSE(point.rolls_b);
    EXPECT_NEAR(point.gap, 0.02, 1e-12);
  }
  EXPECT_EQ(points(0.05).size(), Cylinder::kRimPoints + 1);
  const std::vector<FacingPoint> tilted = points(0.3);
  ASSERT_EQ(tilted.size(), 1u);
  EXPECT_TRUE(tilted[0].rolls_b);
  EXPECT_NEAR(tilted[0].gap, 0.22 - 0.2 * std::cos(0.3) - 0.1 * std::sin(0.3), 1e-12);
  const std::vector<FacingPoint> lying = points(std::numbers::pi / 2);
  ASSERT_EQ(lying.size(), 2u);
  for (const FacingPoint& point : lying)
    EXPECT_TRUE(point.rolls_b && std::abs(point.gap - 0.12) < 1e-9);
}

// A ball rolls wherever it is touched, a cylinder at its side and not at its ends.
TEST(RoundPoints, OfACylinderUnderABallTheSideRollsAndTheEndDoesNot) {
  const auto point_with_ball_at = [](const Vector3& center) {
    return nearest_point(placed(kSphere, Quaternion::Identity(), center),
                         placed(kCylinder, Quaternion::Identity(), Vector3::Zero()));
  };
  const FacingPoint at_side = point_with_ball_at({0.23, 0, 0.05}),
                    at_end = point_with_ball_at({0.02, 0, 0.33});
  EXPECT_NEAR(at_side.gap, 0.01, 1e-12);
  EXPECT_TRUE(at_side.rolls_a && at_side.rolls_b);
  EXPECT_NEAR(at_end.gap, 0.01, 1e-12);
  EXPECT_TRUE(at_end.rolls_a && !at_end.rolls_b);
}

// A standing cylinder half over the edge of a table has what lies on it of its rim, and the ends of the edge.
TEST(RoundPoints, AnEndOverAnEdgeIsHeldByTheEdge) {
  const BodyForm table =
      placed({{0, 0, -0.1}, {1, 1, 0.2}}, Quaternion::Identity(), Vector3::Zero());
  std::vector<FacingPoint> found;
  form_points(table, placed(kCylinder, Quaternion::Identity(), {0.5, 0, 0.2}), Vector3::Zero(),
              0.01, found);
  double farthest = -1;
  for (const FacingPoint& point : found) {
    EXPECT_NEAR(point.gap, 0, 1e-12);
    farthest = std::max(farthest, point.on_a.x());
  }
  EXPECT_NEAR(farthest, 0.5, 1e-9);
}

// Closed forms of a cylinder and a ball; of a hull those of the box it is, turned so that no axis is one of
// its own.
TEST(UniformSolids, HaveTheirInertia) {
  const double mass = 3;
  const MassProperties cylinder =
      uniform_solid(mass, cylinder_shape({1, 2, 3}, {Vector3::UnitX(), 0.1, 0.4}));
  EXPECT_NEAR(cylinder.inertia(0, 0), mass * 0.01 / 2, 1e-15);
  EXPECT_NEAR(cylinder.inertia(1, 1), mass * (0.03 + 0.16) / 12, 1e-15);
  const MassProperties ball = uniform_solid(mass, sphere_shape({1, 2, 3}, 0.1));
  EXPECT_NEAR(ball.inertia(2, 2), 0.4 * mass * 0.01, 1e-15);
  const Quaternion turn(Eigen::AngleAxisd(0.7, Vector3(1, 2, 3).normalized()));
  const Vector3 size(0.2, 0.3, 0.5), center(0.4, -0.2, 1);
  std::vector<Vector3> corners;
  for (const Vector3& corner : outline_points({Vector3::Zero(), size}))
    corners.push_back(center + turn * corner);
  const BodyShape hull = hull_shape(corners);
  const MassProperties body = uniform_solid(mass, hull);
  const Matrix3 r = turn.toRotationMatrix();
  EXPECT_NEAR(volume_of(hull), size.prod(), 1e-14);
  EXPECT_LT((body.center_of_mass - center).norm(), 1e-13);
  EXPECT_LT((body.inertia - r * solid_box_inertia(mass, size) * r.transpose()).norm(), 1e-13);
}

TEST(LevelTops, AreThoseOfUprightSolids) {
  EXPECT_EQ(level_top(kBox, {0.1, 0.05}), 0.25);
  EXPECT_EQ(level_top(kBox, {0.15, 0.1}), 0.25) << "a corner";
  EXPECT_EQ(level_top(kBox, {0.2, 0}), std::nullopt);
  EXPECT_EQ(level_top(kCylinder, {0.09, 0}), 0.2);
  EXPECT_EQ(level_top(kCylinder, {0.09, 0.09}), std::nullopt);
  EXPECT_EQ(level_top(kSphere, {0, 0}), std::nullopt);
  EXPECT_EQ(level_top(kHull, {0, 0}), std::nullopt) << "a tip";
  EXPECT_NEAR(level_top(hull_shape(outline_points(kBox)), {0.1, 0.05}).value(), 0.25, 1e-12);
}

}  // namespace
}  // namespace gurney
