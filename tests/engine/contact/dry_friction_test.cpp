#include "engine/contact/dry_friction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace gurney {
namespace {

constexpr double kTau = 1e-3;
const DryFriction kJoint{2000, 0.3};

TEST(DryFriction, SticksAsASpringBelowTheLimit) {
  const auto r = kJoint.evaluate(1e-4, 0.1, 1.0, kTau);
  EXPECT_DOUBLE_EQ(r.torque, -2000 * (1e-4 + 1e-4) - 0.03);
  EXPECT_DOUBLE_EQ(r.deflection, 2e-4);
  EXPECT_DOUBLE_EQ(r.rate_slope, 2 + 0.3);
  EXPECT_EQ(r.limit_slope, 0);
  EXPECT_FALSE(r.slips);
}

TEST(DryFriction, SlipsAtTheLimitAgainstTheRate) {
  for (double rate : {-5.0, 5.0}) {
    const auto r = kJoint.evaluate(0, rate, 1.0, kTau);
    EXPECT_DOUBLE_EQ(r.torque, std::copysign(1.0, -rate) - 0.3 * rate);
    EXPECT_DOUBLE_EQ(r.deflection, std::copysign(1.0 / 2000, rate));
    EXPECT_EQ(r.rate_slope, 0.3);
    EXPECT_EQ(r.limit_slope, std::copysign(1.0, -rate));
    EXPECT_TRUE(r.slips);
  }
}

TEST(DryFriction, DoesNotCreepHoweverLongTheLoadLasts) {
  double deflection = 0.99 / 2000;
  for (int i = 0; i < 100000; ++i) {
    const auto r = kJoint.evaluate(deflection, 0, 1.0, kTau);
    ASSERT_EQ(r.deflection, deflection);
    deflection = r.deflection;
  }
}

TEST(DryFriction, ZeroLimitSlipsAndInfiniteLimitNeverDoes) {
  EXPECT_TRUE(kJoint.evaluate(0, 1e-12, 0, kTau).slips);
  EXPECT_DOUBLE_EQ(kJoint.evaluate(0, 2, 0, kTau).torque, -0.6);
  const auto held = kJoint.evaluate(0, 1e6, std::numeric_limits<double>::infinity(), kTau);
  EXPECT_FALSE(held.slips);
  EXPECT_DOUBLE_EQ(held.torque, -2000 * 1e3 - 3e5);
}

TEST(DryFriction, SlopesAreThoseOfTheTorque) {
  // Piecewise linear: central differences are exact but for rounding (1 / 1e-6 * 1e-16).
  const double step = 1e-6;
  for (double deflection : {-4e-4, 0.0, 3e-4})
    for (double rate : {-3.0, -0.05, 0.04, 2.0}) {
      const auto r = kJoint.evaluate(deflection, rate, 1.0, kTau);
      const auto torque = [&](double w, double limit) {
        return kJoint.evaluate(deflection, w, limit, kTau).torque;
      };
      EXPECT_NEAR(r.rate_slope, -(torque(rate + step, 1) - torque(rate - step, 1)) / (2 * step),
                  1e-8);
      EXPECT_NEAR(r.limit_slope, (torque(rate, 1 + step) - torque(rate, 1 - step)) / (2 * step),
                  1e-8);
    }
}

}  // namespace
}  // namespace gurney
