#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "engine/contact/impact_law.h"
#include "engine/run/simulate.h"
#include "studies/verification/scenes/blocks.h"

// A block on a smooth floor meets a rough wall with a vertical edge, at an angle: it slides, sticks
// and slides back while it turns. The law of contact has no time of its own, so that its result
// tends to that of a rigid contact as the stiffness grows, and the default is near that limit.
namespace gurney {
namespace {

constexpr double kMass = 40, kStep = 0.004, kSpeed = 1;
const Vector3 kSize(0.5, 0.4, 0.6);
const double kInertia = kMass / 12 * (kSize.x() * kSize.x() + kSize.y() * kSize.y());
const double kArm = 0.5 * kSize.head<2>().norm();

struct Blow {
  double yaw_degrees, along, friction, restitution;
  double yaw() const { return yaw_degrees * std::numbers::pi / 180; }
  /// The edge that is foremost, block axes.
  Vector2 edge() const { return {0.5 * kSize.x(), yaw_degrees > 0 ? -0.2 : 0.2}; }
  std::string name() const {
    return "yaw " + std::to_string(yaw_degrees) + ", along " + std::to_string(along) +
           ", friction " + std::to_string(friction);
  }
};

// Sliding through, sliding that reverses, sticking.
constexpr Blow kBlows[] = {{20, 0.6, 0.15, 0.5}, {20, 0.3, 0.6, 0.5}, {10, 0.5, 0.4, 0.5},
                           {30, -0.4, 0.3, 0.5}, {45, 0.5, 0.5, 0.3}, {25, 0.2, 0.3, 0.9}};

struct Motion {
  Vector2 velocity;
  double yaw_rate;
};

/// The law, integrated for the block in the plane until the edge leaves the wall x = 0, with two
/// points (on top and at the bottom) of stiffness k and a hundred thousandth of sqrt(m / k) a step.
Motion integrated(const Blow& blow, double k) {
  const double spring = 2 * k, tangential = 0.8 * spring;
  const double number = ImpactLaw::damping_number(blow.restitution);
  const double h = 1e-5 * std::sqrt(kMass / spring);
  Vector2 v(kSpeed, blow.along);
  double yaw = blow.yaw(), yaw_rate = 0, deflection = 0;
  double depth = 0;  // of the edge behind the wall
  do {
    const Vector2 arm = Eigen::Rotation2Dd(yaw) * blow.edge();
    const Vector2 u = v + yaw_rate * Vector2(-arm.y(), arm.x());
    depth += h * u.x();
    const double d = std::max(depth, 0.0);
    const double normal = spring * d * std::max(0.0, 1 + number * u.x() / kSpeed);
    // -(k_t e + c_t e') with c_t = k_t x d / v0, implicit in e: c_t vanishes at the touch.
    const double damping = tangential * number * d / kSpeed / h;
    const double trial = -tangential * deflection - (tangential + damping) * h * u.y();
    const double friction = std::clamp(trial, -blow.friction * normal, blow.friction * normal);
    deflection = (damping * deflection - friction) / (tangential + damping);
    const Vector2 force(-normal, friction);
    v += h / kMass * force;
    yaw_rate += h / kInertia * (arm.x() * force.y() - arm.y() * force.x());
    yaw += h * yaw_rate;
  } while (depth > 0);
  return {v, yaw_rate};
}

Motion simulated(const Blow& blow, const ContactConstants& wall, double* closure = nullptr) {
  Scene scene = blocks::block(kMass, kSize, {.friction = 0});
  scene.items[0].initial.velocity = {kSpeed, blow.along, 0};
  scene.items[0].initial.yaw = blow.yaw();
  const double front = (Eigen::Rotation2Dd(blow.yaw()) * blow.edge()).x();
  blocks::add_wall(scene, front + 0.03, wall);
  const Response response = simulate(scene, {}, blocks::run_for(0.048, kStep, kStep));
  EXPECT_EQ(response.outcome, Outcome::kStopped) << response.cause;
  EXPECT_EQ(response.impacts.size(), 1u) << blow.name();
  if (closure != nullptr) *closure = response.quality.energy_closure;
  const std::vector<Sample>& history = response.items[0].history;
  const Sample &end = history.back(), &before = history[history.size() - 2];
  return {end.points[0].velocity.head<2>(), (end.yaw - before.yaw) / (end.time - before.time)};
}

struct Bound {
  double velocity, yaw_rate;
};

/// What turning in the contact may change. It lasts at most T = 2 pi sqrt(m / 2 k), twice the half
/// period of the whole mass, in which the block turns by less than theta = w T and the lever of the
/// force changes by at most r theta. The effective mass 1 / (1/m + a^2/I), and the impulse with it,
/// change by the fraction 2 m a r theta / I, a <= r; the impulse is below (1 + e) (1 + mu) m v.
Bound turning(const Blow& blow, double k, double yaw_rate) {
  const double theta = std::abs(yaw_rate) * 2 * std::numbers::pi * std::sqrt(kMass / (2 * k));
  const double impulse = (1 + blow.restitution) * (1 + blow.friction) * kSpeed;
  const double velocity = impulse * 2 * kMass * kArm * kArm * theta / kInertia;
  return {velocity, velocity * kMass * kArm / kInertia};
}

/// Kinks of the force inside steps: touch, slip that ends, slip that begins, parting. Each changes
/// the velocity by at most (gamma phi)^2 of what an impact does, phi = 0.1 being the largest phase
/// of a step (docs/theory/impact.md).
Bound kinks(const Blow& blow) {
  const double velocity = 4 * std::pow(0.293 * 0.1, 2) * (1 + blow.restitution) * kSpeed;
  return {velocity, velocity * kMass * kArm / kInertia};
}

void expect_near(const Motion& a, const Motion& b, const Bound& bound, const std::string& which) {
  EXPECT_LT((a.velocity - b.velocity).norm(), bound.velocity) << which;
  EXPECT_LT(std::abs(a.yaw_rate - b.yaw_rate), bound.yaw_rate) << which;
}

TEST(ObliqueImpact, FollowsItsLawAtAnyStiffness) {
  for (const Blow& blow : kBlows)
    for (double k : {1e6, 1e8}) {
      double closure = 1;
      const Motion engine = simulated(
          blow, {.stiffness = k, .restitution = blow.restitution, .friction = blow.friction},
          &closure);
      expect_near(engine, integrated(blow, k), kinks(blow), blow.name());
      EXPECT_LT(closure, 2e-3) << blow.name();  // as WallImpact, of friction
    }
}

TEST(ObliqueImpact, TendsToARigidContactAsItGetsStiffer) {
  for (const Blow& blow : kBlows) {
    // The limit: a contact that is ten thousand times stiffer turns a hundredth as far.
    const Motion rigid = integrated(blow, 1e12);
    const auto away = [&](double k) -> Bound {
      const Motion motion = integrated(blow, k);
      return {(motion.velocity - rigid.velocity).norm(),
              std::abs(motion.yaw_rate - rigid.yaw_rate)};
    };
    for (double k : {1e6, 1e8, 1e9}) {
      const Bound most = turning(blow, k, rigid.yaw_rate);
      EXPECT_LT(away(k).velocity, most.velocity) << blow.name();
      EXPECT_LT(away(k).yaw_rate, most.yaw_rate) << blow.name();
    }
    const ContactConstants wall{.restitution = blow.restitution, .friction = blow.friction};
    ContactConstants stiffer = wall;
    stiffer.stiffness *= 10;
    const Bound turn = away(wall.stiffness), kink = kinks(blow);
    EXPECT_LT(turn.velocity, 0.008 * kSpeed) << blow.name();  // what impact.md states
    const Motion plain = simulated(blow, wall);
    expect_near(plain, rigid, {kink.velocity + turn.velocity, kink.yaw_rate + turn.yaw_rate},
                blow.name());
    expect_near(plain, simulated(blow, stiffer),
                {2 * kink.velocity + turn.velocity, 2 * kink.yaw_rate + turn.yaw_rate},
                blow.name());
  }
}

}  // namespace
}  // namespace gurney
