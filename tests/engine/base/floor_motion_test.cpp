#include "engine/base/floor_motion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/error_text.h"

namespace gurney {
namespace {

FloorMotion ramp() {
  Eigen::Matrix3Xd a(3, 4);
  a << 0, 1, 3, -2,  //
      1, 1, 1, 1,    //
      0, 0, 2, 0;
  return FloorMotion(0.5, a, "ramp");
}

TEST(FloorMotion, IsLinearBetweenSamplesAndZeroOutside) {
  const FloorMotion motion = ramp();
  EXPECT_DOUBLE_EQ(motion.duration(), 1.5);
  EXPECT_NEAR((motion.acceleration_at(0.75) - Vector3(2, 1, 1)).norm(), 0, 1e-15);
  EXPECT_NEAR((motion.acceleration_at(1.25) - Vector3(0.5, 1, 1)).norm(), 0, 1e-15);
  EXPECT_EQ(motion.acceleration_at(-0.001).norm(), 0);
  EXPECT_EQ(motion.acceleration_at(1.501).norm(), 0);
}

TEST(FloorMotion, VelocityIsTheExactIntegral) {
  const FloorMotion motion = ramp();
  // Trapezoids of the x component: 0.25, 1, 0.25; inside the second, 1 (t - 0.5) + 2 (t - 0.5)^2.
  EXPECT_NEAR(motion.velocity_at(0.5).x(), 0.25, 1e-15);
  EXPECT_NEAR(motion.velocity_at(0.8).x(), 0.25 + 0.3 + 2 * 0.09, 1e-15);
  EXPECT_NEAR(motion.velocity_at(1.5).x(), 1.5, 1e-15);
  EXPECT_NEAR(motion.velocity_at(9).x(), 1.5, 1e-15);
  EXPECT_EQ(motion.velocity_at(0).norm(), 0);
}

TEST(FloorMotion, ResidualsAreThoseOfTheClosedForm) {
  const FloorMotion motion = ramp();
  EXPECT_NEAR(motion.residual_velocity().y(), 1.5, 1e-15);
  EXPECT_NEAR(motion.residual_displacement().y(), 0.5 * 1.5 * 1.5, 1e-15);
  // z: a rises and falls as a triangle of height 2 over 1 s with its middle at 1 s: impulse 1 m/s,
  // arm 0.5 s.
  EXPECT_NEAR(motion.residual_velocity().z(), 1, 1e-15);
  EXPECT_NEAR(motion.residual_displacement().z(), 0.5, 1e-15);
}

TEST(FloorMotion, RestIsRest) {
  const FloorMotion motion;
  EXPECT_TRUE(motion.at_rest());
  EXPECT_EQ(motion.duration(), 0);
  EXPECT_EQ(motion.velocity_at(3).norm(), 0);
  EXPECT_EQ(motion.acceleration_at(3).norm(), 0);
}

TEST(FloorMotion, RotationIsLinearBetweenSamplesAndItsIntegralsAreExact) {
  FloorRotation rotation{Eigen::Matrix3Xd(3, 4), Eigen::Matrix3Xd(3, 4)};
  rotation.angle << 0, 0.2, 0.2, 0, 0, 0, 0, 0.4, 0, 0, 0.3, 0;
  rotation.acceleration << 1, 1, 1, 1, 0, 2, 0, 0, 0, 0, 0, 2;
  const FloorMotion motion = ramp().with_rotation(rotation);
  EXPECT_TRUE(motion.rotates());
  EXPECT_FALSE(ramp().rotates());
  EXPECT_EQ(motion.acceleration(), ramp().acceleration());
  EXPECT_EQ(motion.velocity_at(0.7), ramp().velocity_at(0.7));
  // 0.2 (0.25)^2 / (2 * 0.5) of the ramp, then 0.05 at 0.5 s and 0.2 a second
  EXPECT_NEAR(motion.integral_of_angle_at(0.25).x(), 0.0125, 1e-16);
  EXPECT_NEAR(motion.integral_of_angle_at(0.75).x(), 0.05 + 0.05, 1e-16);
  EXPECT_NEAR(motion.integral_of_angle_at(9).y(), 0.1, 1e-16);
  EXPECT_NEAR(motion.angular_velocity_at(9).x(), 1.5, 1e-15);
  EXPECT_NEAR(motion.angular_velocity_at(1).y(), 1, 1e-15);
  EXPECT_NEAR(motion.integral_of_angle_at(9).z(), 0.15, 1e-16);
  EXPECT_NEAR(motion.angular_velocity_at(9).z(), 0.5, 1e-16);
  // The yaw stays.
  const Vector3 factors(3, 3, 1);
  const FloorRotation rocking = motion.with_rocking_times(3).rotation();
  EXPECT_EQ(rocking.angle, factors.asDiagonal() * rotation.angle);
  EXPECT_EQ(rocking.acceleration, factors.asDiagonal() * rotation.acceleration);
  EXPECT_FALSE(ramp().with_rocking_times(3).rotates());
}

TEST(FloorMotion, RefusesWhatIsNoRotation) {
  FloorRotation rotation{Eigen::Matrix3Xd::Zero(3, 4), Eigen::Matrix3Xd::Zero(3, 3)};
  EXPECT_EQ(
      error_text([&] { ramp().with_rotation(rotation); }),
      "the rotation of a floor must have as many samples as its acceleration, 4, got 4 and 3");
  rotation.acceleration = Eigen::Matrix3Xd::Constant(3, 4, std::nan(""));
  EXPECT_EQ(error_text([&] { ramp().with_rotation(rotation); }),
            "the rotation of a floor must be finite at every sample");
}

TEST(FloorMotion, RefusesWhatIsNoMotion) {
  Eigen::Matrix3Xd a = Eigen::Matrix3Xd::Zero(3, 3);
  EXPECT_EQ(error_text([&] { FloorMotion(0, a); }),
            "the time step of a floor motion must be positive, got 0.000000");
  EXPECT_EQ(error_text([&] { FloorMotion(std::nan(""), a); }),
            "the time step of a floor motion must be positive, got nan");
  a(1, 2) = std::nan("");
  EXPECT_EQ(error_text([&] { FloorMotion(0.01, a); }),
            "a floor motion must be finite at every sample");
}

}  // namespace
}  // namespace gurney
