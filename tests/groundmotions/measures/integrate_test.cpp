#include <gtest/gtest.h>

#include <cmath>

#include "engine/base/floor_motion.h"
#include "groundmotions/measures/peaks.h"

namespace gurney::groundmotions {
namespace {

// a = t is linear: v = t^2 / 2, d = t^3 / 6. Every number is a whole number of halves or sixths.
TEST(Integrate, IsExactForALine) {
  const IntegratedMotion motion = integrated(1, Eigen::VectorXd::LinSpaced(5, 0, 4));
  for (int i = 0; i < 5; ++i) {
    EXPECT_DOUBLE_EQ(motion.velocity[i], i * i / 2.0);
    EXPECT_DOUBLE_EQ(motion.displacement[i], i * i * i / 6.0);
  }
}

// a = sin(w t): v = (1 - cos(w t)) / w, d = t / w - sin(w t) / w^2. Linear interpolation is off by
// e <= (w h)^2 / 8 at most, so v by e T and d by e T^2 / 2.
TEST(Integrate, FollowsASine) {
  const double h = 0.005, w = 10, duration = 2, e = w * w * h * h / 8;
  const Eigen::ArrayXd t = Eigen::ArrayXd::LinSpaced(401, 0, duration);
  const IntegratedMotion motion = integrated(h, (w * t).sin());
  const Eigen::ArrayXd v = (1 - (w * t).cos()) / w, d = t / w - (w * t).sin() / (w * w);
  EXPECT_LT((motion.velocity.array() - v).abs().maxCoeff(), e * duration);
  EXPECT_LT((motion.displacement.array() - d).abs().maxCoeff(), e * duration * duration / 2);
}

// The same integrals as those of the floor that the item stands on.
TEST(Integrate, EndsAsTheFloorMotionDoes) {
  Eigen::VectorXd a(6);
  a << 1, -3, 2, 0.5, 4, -1;
  const FloorMotion floor(0.02, Vector3(1, 0, 0) * a.transpose());
  const EndMotion end = end_motion(0.02, a);
  EXPECT_DOUBLE_EQ(end.velocity, floor.residual_velocity().x());
  EXPECT_DOUBLE_EQ(end.displacement, floor.residual_displacement().x());
  EXPECT_EQ(end_motion(0.02, Eigen::VectorXd()).velocity, 0);
}

}  // namespace
}  // namespace gurney::groundmotions
