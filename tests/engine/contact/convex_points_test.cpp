#include "engine/contact/convex_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

// Boxes and hulls that face each other: which points, which normal, which gap.
namespace gurney {
namespace {

constexpr double kMargin = 0.02;
const Vector3 kStill = Vector3::Zero();

ConvexShape wall() { return convex_box({0.1, 0, 1.5}, {0.2, 3, 3}); }

/// A block before the face x = 0 of the wall.
ConvexShape block(double gap) { return convex_box({-0.25 - gap, 0, 0.3}, {0.5, 0.4, 0.6}); }

std::vector<FacingPoint> between(const ConvexShape& a, const ConvexShape& b,
                                 const Vector3& motion = kStill, double margin = kMargin) {
  std::vector<FacingPoint> points;
  convex_points(a, b, motion, margin, points);
  return points;
}

TEST(ConvexPoints, AFaceHasItsFourCornersFromTheMarginToOverlap) {
  for (double gap : {0.0199, 0.005, 1e-5, 1e-9, 0.0, -1e-9, -1e-5, -0.005}) {
    const auto points = between(block(gap), wall());
    ASSERT_EQ(points.size(), 4u) << gap;
    for (double y : {-0.2, 0.2})
      for (double z : {0.0, 0.6})
        EXPECT_TRUE(std::any_of(
            points.begin(), points.end(),
            [&](const FacingPoint& p) { return (p.on_a - Vector3(-gap, y, z)).norm() < 1e-12; }))
            << gap << ", " << y << ", " << z;
    for (const FacingPoint& p : points) {
      EXPECT_NEAR(p.gap, gap, 1e-12);
      EXPECT_NEAR((p.normal + Vector3::UnitX()).norm(), 0, 1e-12);
      EXPECT_NEAR(p.on_b.x(), 0, 1e-12);
    }
  }
  EXPECT_TRUE(between(block(0.0201), wall()).empty());
}

TEST(ConvexPoints, WhatIsBeyondTheEdgeOfTheOtherIsLeftOut) {
  // The wall ends at y = 3/2 - 1.4 = 0.1: two corners of the block are left, and two points of its
  // outline at the edge.
  const auto points = between(block(0.001), convex_box({0.1, -1.4, 1.5}, {0.2, 3, 3}));
  ASSERT_EQ(points.size(), 4u);
  for (const FacingPoint& p : points) {
    EXPECT_LT(p.on_a.y(), 0.1 + 1e-12);
    EXPECT_TRUE(std::abs(p.on_a.y() - 0.1) < 1e-12 || std::abs(p.on_a.y() + 0.2) < 1e-12);
  }
}

TEST(ConvexPoints, CrossingEdgesMeetInOnePoint) {
  // Two roof ridges across each other: z is the normal of neither's face.
  const Quaternion on_x(Eigen::AngleAxisd(M_PI / 4, Vector3::UnitX()));
  const Quaternion on_y(Eigen::AngleAxisd(M_PI / 4, Vector3::UnitY()));
  const ConvexShape box = convex_box(kStill, {1, 1, 1});
  for (double gap : {0.01, -0.01}) {
    const auto points =
        between(box.placed(on_x, {0.1, -0.2, std::sqrt(2.0) + gap}), box.placed(on_y, {0, 0, 0}));
    std::vector<FacingPoint> near;
    for (const FacingPoint& p : points)
      if (p.gap < gap + 1e-9) near.push_back(p);
    ASSERT_EQ(near.size(), 1u);
    EXPECT_NEAR((near[0].on_b - Vector3(0, -0.2, std::sqrt(0.5))).norm(), 0, 1e-12);
    EXPECT_NEAR((near[0].normal - Vector3::UnitZ()).norm(), 0, 1e-12);
  }
}

TEST(ConvexPoints, BodiesThatPassACornerMeetOnTheSideTheyReachLast) {
  // 4 mm before the wall's face and 1 mm below its end: moving mostly along x it strikes nothing
  // unless it also comes 1 mm up before the 4 mm are over.
  const ConvexShape a = block(0.004), b = convex_box({0.1, 0, 2.101}, {0.2, 3, 3});
  ASSERT_NEAR(b.lowest(Vector3::UnitZ()), 0.601, 1e-12);
  EXPECT_TRUE(between(a, b).empty());
  const auto face = between(a, b, {0.008, 0, 0.004});  // at 2 ms in z, 4 mm in x
  ASSERT_FALSE(face.empty());
  for (const FacingPoint& p : face) {
    EXPECT_NEAR((p.normal + Vector3::UnitX()).norm(), 0, 1e-12);
    EXPECT_NEAR(p.gap, 0.004, 1e-12);
  }
  const auto end = between(a, b, {0.008, 0, 0.0012});
  ASSERT_FALSE(end.empty());
  for (const FacingPoint& p : end) {
    EXPECT_NEAR((p.normal + Vector3::UnitZ()).norm(), 0, 1e-12);
    EXPECT_NEAR(p.gap, 0.001, 1e-12);
  }
  EXPECT_TRUE(between(a, b, {0.008, 0, 0.0008}).empty());
}

/// Nearest point of a box to p.
Vector3 nearest(const Vector3& half, const Quaternion& q, const Vector3& center, const Vector3& p) {
  const Vector3 local = q.conjugate() * (p - center);
  return center + q * local.cwiseMax(-half).cwiseMin(half);
}

/// How far p is inside the box; negative outside.
double depth(const Vector3& half, const Quaternion& q, const Vector3& center, const Vector3& p) {
  return (half - (q.conjugate() * (p - center)).cwiseAbs()).minCoeff();
}

TEST(ConvexPoints, OfBoxesInAnyPoseLieOnBothAndFindTheDistance) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> u(-1, 1);
  const auto vector = [&] { return Vector3(u(random), u(random), u(random)); };
  int found = 0, overlaps = 0, same_distance = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const Vector3 half_a = vector().cwiseAbs() + Vector3::Constant(0.1);
    const Vector3 half_b = vector().cwiseAbs() + Vector3::Constant(0.1);
    const Quaternion qa = Quaternion(u(random), u(random), u(random), u(random)).normalized();
    const Quaternion qb = Quaternion(u(random), u(random), u(random), u(random)).normalized();
    const Vector3 ca = 1.5 * vector(), cb = kStill;
    const ConvexShape a = convex_box(kStill, 2 * half_a).placed(qa, ca);
    const ConvexShape b = convex_box(kStill, 2 * half_b).placed(qb, cb);
    const auto points = between(a, b, kStill, 10);
    // Alternating projections on two convex sets find their distance (Cheney & Goldstein 1959).
    Vector3 p = ca, q = cb;
    for (int i = 0; i < 3000; ++i) {
      q = nearest(half_b, qb, cb, p);
      p = nearest(half_a, qa, ca, q);
    }
    // They may be slow; what separates the bodies across p - q is a lower bound at any time.
    const double distance = (p - q).norm();
    const Vector3 across = (p - q) / std::max(distance, 1e-12);
    const double bound = a.lowest(across) + b.lowest(-across);
    double least = 10;
    for (const FacingPoint& point : points) {
      EXPECT_NEAR(depth(half_a, qa, ca, point.on_a), 0, 1e-9);
      EXPECT_NEAR(depth(half_b, qb, cb, point.on_b), 0, 1e-9);
      EXPECT_NEAR(point.gap, point.normal.dot(point.on_a - point.on_b), 1e-12);
      EXPECT_NEAR(point.normal.norm(), 1, 1e-12);
      EXPECT_GE((point.on_a - point.on_b).norm(), bound - 1e-9);
      least = std::min(least, point.gap);
    }
    found += !points.empty();
    if (distance < 1e-6) {
      ++overlaps;
      EXPECT_LT(least, 1e-6) << "bodies that overlap have points";
    } else if (!points.empty() && distance - bound < 1e-7) {
      same_distance += std::abs(least - distance) < 1e-6;
    }
  }
  EXPECT_GT(overlaps, 300);
  EXPECT_GT(found, 500);
  EXPECT_GT(same_distance, 300);
}

TEST(ConvexPoints, AHullOfTheCornersOfABoxIsTheBox) {
  ConvexShape hull = convex_hull({{-1, -1, 0},
                                  {1, -1, 0},
                                  {1, 1, 0},
                                  {-1, 1, 0},
                                  {0, 0, 0},
                                  {-1, -1, 2},
                                  {1, -1, 2},
                                  {1, 1, 2},
                                  {-1, 1, 2},
                                  {0, 1, 2}});
  EXPECT_EQ(hull.faces.size(), 6u);
  EXPECT_EQ(hull.edges.size(), 3u);
  for (const ConvexShape::Face& face : hull.faces) EXPECT_EQ(face.loop.size(), 4u);
  // Rounded to tenths of a millimetre a face is still one.
  const Quaternion turn(Eigen::AngleAxisd(0.3, Vector3(1, 2, 3).normalized()));
  std::vector<Vector3> rounded;
  for (const Vector3& corner : hull.placed(turn, {0, 0, 0}).corners)
    rounded.push_back(Vector3((corner * 1e4).array().round() / 1e4));
  EXPECT_EQ(convex_hull(rounded).faces.size(), 6u);
}

}  // namespace
}  // namespace gurney
