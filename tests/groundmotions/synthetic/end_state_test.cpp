#include <gtest/gtest.h>

#include <cmath>

#include "groundmotions/measures/peaks.h"
#include "groundmotions/synthetic/component.h"

namespace gurney::groundmotions {
namespace {

TEST(EndState, IsTheExactIntegral) {
  // 3 m/s2 for 2 s: 6 m/s and 6 m.
  const Eigen::Vector2d end = end_state(0.5, Eigen::VectorXd::Constant(5, 3));
  EXPECT_DOUBLE_EQ(end[0], 6);
  EXPECT_DOUBLE_EQ(end[1], 6);
}

TEST(EndState, IsSet) {
  Eigen::VectorXd a = Eigen::VectorXd::LinSpaced(50, 1, 3);
  set_end_state(0.1, a, {0.3, -2});
  EXPECT_NEAR(end_state(0.1, a)[0], 0.3, 1e-12);
  EXPECT_NEAR(end_state(0.1, a)[1], -2, 1e-12);
}

TEST(AccelerationOf, IntegratesBackToTheDisplacement) {
  const double step = 0.01;
  Eigen::VectorXd d(301);
  for (Eigen::Index i = 0; i < d.size(); ++i) {
    const double t = static_cast<double>(i) * step;
    d[i] = 0.2 * std::pow(std::sin(t), 2) * std::sin(7 * t);
  }
  const Eigen::VectorXd a = acceleration_of(step, d);
  EXPECT_LT((integrated(step, a).displacement - d).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_NEAR(end_state(step, a)[0], 0, 1e-12);
  // In the middle, d'' of the closed form: with the spline's relative error of (omega dt)^2 / 12,
  // omega = 9 at mostand 0.2 omega^2 the largest acceleration.
  const double t = 1.5;
  const double exact =
      0.2 * (2 * std::cos(2 * t) * std::sin(7 * t) + 14 * std::sin(2 * t) * std::cos(7 * t) -
             49 * std::pow(std::sin(t), 2) * std::sin(7 * t));
  EXPECT_NEAR(a[150], exact, 0.2 * 81 * 81e-4 / 12);
}

}  // namespace
}  // namespace gurney::groundmotions
