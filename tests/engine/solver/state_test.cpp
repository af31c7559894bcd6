#include "engine/solver/state.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace gurney {
namespace {

TEST(Rotated, IsTheProductOfEigen) {
  std::mt19937 engine(5);
  std::normal_distribution<double> normal;
  const auto vector = [&](double size) -> Vector3 {
    return size * Vector3(normal(engine), normal(engine), normal(engine));
  };
  for (const double size : {0.0, 1e-12, 1e-4, 0.1, 2.0})
    for (int trial = 0; trial < 50; ++trial) {
      const Quaternion start =
          Quaternion(normal(engine), normal(engine), normal(engine), normal(engine)).normalized();
      const Vector3 angle = vector(size);
      Quaternion expected = start;
      if (angle.norm() > 0)
        expected = Quaternion(Eigen::AngleAxisd(angle.norm(), angle.normalized())) * start;
      // Products of unit quaternions: some ten roundings of numbers below 1.
      EXPECT_NEAR((rotated(angle, start).coeffs() - expected.coeffs()).norm(), 0, 2e-15);
      EXPECT_NEAR(rotated(angle, start).norm(), 1, 5e-16);
    }
}

}  // namespace
}  // namespace gurney
