#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/contact/impact_law.h"
#include "engine/simulate.h"
#include "studies/verification/scenes/blocks.h"

// A block that slides without friction into a wall: momentum, restitution and contact time.
namespace gurney {
namespace {

constexpr double kMass = 80, kGap = 0.1;
const Vector3 kSize(0.5, 0.4, 0.6);

ContactConstants slippery() { return {.friction = 0}; }

Response hit(double speed, const ContactConstants& wall) {
  constexpr double kStep = 0.004;
  Scene scene = blocks::block(kMass, kSize, slippery());
  blocks::add_wall(scene, 0.5 * kSize.x() + kGap, wall);
  scene.items[0].initial.velocity = {speed, 0, 0};
  return simulate(scene, {}, blocks::run_for(2.5 * kGap / speed, kStep, kStep));
}

TEST(WallImpact, TheBlockReboundsWithTheRestitutionStatedAtEverySpeed) {
  for (double e : {0.05, 0.2, 0.4, 0.7, 1.0})
    for (double speed : {0.2, 0.8, 1.0, 2.5}) {
      // It parts at e times the speed, and below 0.01 m/s no step is cut for a contact.
      if (e * speed < 2 * ImpactLaw::kLeastApproach) continue;
      const Response response = hit(speed, {.restitution = e, .friction = 0});
      ASSERT_EQ(response.outcome, Outcome::kStopped) << response.cause;
      ASSERT_EQ(response.impacts.size(), 1u) << "e " << e << ", " << speed << " m/s";
      const Impact& impact = response.impacts[0];
      // 32 steps of a second-order method in half a period of the spring: (pi / 32)^2 / 12 = 0.08 %
      // of the speed, and as much again for the touch and the end inside steps.
      EXPECT_NEAR(response.items[0].history.back().velocity.x(), -e * speed, 0.003 * speed)
          << "e " << e << ", " << speed << " m/s";
      EXPECT_NEAR(impact.approach_speed, speed, 1e-6 * speed);
      EXPECT_NEAR(impact.impulse, kMass * (1 + e) * speed, 0.003 * kMass * speed);
      EXPECT_NEAR(impact.time, kGap / speed, 2e-4);
      EXPECT_NEAR(impact.normal.x(), -1, 1e-9);
      EXPECT_EQ(impact.body, "chassis");
      EXPECT_EQ(impact.other, "wall");
      EXPECT_TRUE(std::isnan(impact.peak_force)) << "restitution states no force";
      // The block slides freely but for the wall: whatever accelerates it is numerical.
      const PointDemands& point = response.items[0].demands.points[0];
      EXPECT_GT(point.numerical_acceleration, speed / impact.duration);
      EXPECT_LT(point.peak_absolute_acceleration, 1e-3 * point.numerical_acceleration);
      EXPECT_TRUE(std::isnan(point.impact_acceleration));
      EXPECT_LT(response.quality.energy_closure, 0.003);
    }
}

TEST(WallImpact, AnUndampedSpringTouchesForPiRootOfMassOverStiffness) {
  // Four corners share the load: k is that of each.
  for (double k : {5e4, 4e5}) {
    const double speed = 0.8, omega = std::sqrt(4 * k / kMass);
    const Response response =
        hit(speed, {.kind = ContactConstants::Kind::kCompliant, .stiffness = k, .friction = 0});
    ASSERT_EQ(response.impacts.size(), 1u);
    const Impact& impact = response.impacts[0];
    // A stage ends up to half a step's phase off the peak: (pi / 32)^2 / 2 = 0.5 %, and starts with
    // the touch inside a step.
    EXPECT_NEAR(impact.duration, std::numbers::pi / omega, 0.01 * std::numbers::pi / omega);
    EXPECT_NEAR(impact.peak_force, kMass * speed * omega, 0.01 * kMass * speed * omega);
    EXPECT_NEAR(response.items[0].demands.points[0].peak_absolute_acceleration, speed * omega,
                0.01 * speed * omega);
    EXPECT_EQ(response.items[0].demands.points[0].impact_acceleration,
              response.items[0].demands.points[0].peak_absolute_acceleration);
    EXPECT_TRUE(std::isnan(response.items[0].demands.points[0].numerical_acceleration));
    EXPECT_NEAR(response.items[0].demands.peak_impact_force, impact.peak_force, 0);
  }
}

/// Rebound of m d'' = -(k d + min(max(c d', -k d), k d)), d(0) = 0, d'(0) = 1: while c d' > k d the
/// force is 2 k d; then a damped spring, until c d' = -k d ends the contact.
struct Damped {
  double restitution, duration;
};
Damped damped_spring(double omega, double zeta) {
  const double fast = std::sqrt(2.0) * omega, c_over_k = 2 * zeta / omega;
  const double t1 = std::atan(fast * c_over_k) / fast;
  const double d1 = std::sin(fast * t1) / fast, v1 = std::cos(fast * t1);
  const double wd = omega * std::sqrt(1 - zeta * zeta);
  const double b = (v1 + zeta * omega * d1) / wd;
  const auto at = [&](double t) {
    const double decay = std::exp(-zeta * omega * t), c = std::cos(wd * t), s = std::sin(wd * t);
    const double d = decay * (d1 * c + b * s);
    const double v = -zeta * omega * d + decay * wd * (b * c - d1 * s);
    return std::pair(d, v);
  };
  double low = 0, high = std::numbers::pi / wd;
  for (int i = 0; i < 100; ++i) {
    const double t = 0.5 * (low + high);
    const auto [d, v] = at(t);
    (d + c_over_k * v > 0 ? low : high) = t;
  }
  return {-at(low).second, t1 + low};
}

TEST(WallImpact, ADampedSpringThatCannotPullReboundsAsItsClosedForm) {
  for (double zeta : {0.1, 0.3, 0.6}) {
    const double k = 2e5, omega = std::sqrt(4 * k / kMass), speed = 1;
    const Damped expected = damped_spring(omega, zeta);
    const Response response = hit(speed, {.kind = ContactConstants::Kind::kCompliant,
                                          .stiffness = k,
                                          .damping = 2 * zeta * k / omega,
                                          .friction = 0});
    ASSERT_EQ(response.impacts.size(), 1u);
    EXPECT_NEAR(-response.items[0].history.back().velocity.x(), expected.restitution, 0.005)
        << zeta;
    EXPECT_NEAR(response.impacts[0].duration, expected.duration, 0.05 * expected.duration);
  }
}

}  // namespace
}  // namespace gurney
