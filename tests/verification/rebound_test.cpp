#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "engine/simulate.h"
#include "studies/verification/scenes/blocks.h"

// What an impact at the default step of 4 ms leaves of the motion: closed forms of rigid bodies.
namespace gurney {
namespace {

constexpr double kMass = 80, kGap = 0.1, kStep = 0.004;
const Vector3 kSize(0.5, 0.4, 0.6);

Vector3 turned(double yaw, const Vector3& v) {
  return Eigen::AngleAxisd(yaw, Vector3::UnitZ()) * v;
}

double yaw_inertia() { return solid_box_inertia(kMass, kSize)(2, 2); }

/// A block without friction on the floor whose front is at x = kSize.x() / 2.
Scene sliding(const Vector3& velocity) {
  Scene scene = blocks::block(kMass, kSize, {.friction = 0});
  scene.items[0].initial.velocity = velocity;
  return scene;
}

/// Runs until the block is as far away as it was, or would be without rebound.
Response run(const Scene& scene, double travel, const Excitation& excitation = {},
             double closure = 5e-4) {
  const double speed = scene.items[0].initial.velocity.norm();
  const Response response =
      simulate(scene, excitation, blocks::run_for(travel / speed, kStep, kStep));
  EXPECT_EQ(response.outcome, Outcome::kStopped) << response.cause;
  // 32 steps of a second-order method in half a period of the spring (pi / 32 of phase each): what
  // they miss of the energy is a few times (pi / 32)^4 = 1e-4.
  EXPECT_LT(response.quality.energy_closure, closure);
  EXPECT_EQ(response.quality.unconverged_steps, 0);
  return response;
}

double yaw_rate(const Response& r) {
  const Sample &a = r.items[0].history[r.items[0].history.size() - 2],
               &b = r.items[0].history.back();
  return (b.yaw - a.yaw) / (b.time - a.time);
}

TEST(Rebound, AFlatFaceReboundsWithTheRestitutionStatedHoweverTheWallIsTurned) {
  for (double yaw : {0.0, std::numbers::pi / 6, -2.0})
    for (double e : {0.2, 0.5, 0.7, 0.9})
      for (double speed : {0.2, 0.8, 2.0}) {
        Scene scene = sliding(turned(yaw, {speed, 0, 0}));
        scene.items[0].initial.yaw = yaw;
        blocks::add_wall(scene, 0.5 * kSize.x() + kGap, {.restitution = e, .friction = 0});
        scene.room.back().rotation = Quaternion(Eigen::AngleAxisd(yaw, Vector3::UnitZ()));
        scene.room.back().position = turned(yaw, scene.room.back().position);
        const Response response = run(scene, 2 * kGap);
        const Vector3 v = turned(-yaw, response.items[0].history.back().velocity);
        const std::string which = "yaw " + std::to_string(yaw) + ", e " + std::to_string(e) + ", " +
                                  std::to_string(speed);
        ASSERT_EQ(response.impacts.size(), 1u) << which;
        // The phase error of a step is (pi / 32)^2 / 12 = 0.08 %, and as much for the touch and the
        // end inside steps.
        EXPECT_NEAR(-v.x(), e * speed, 0.002 * speed) << which;
        EXPECT_NEAR(v.y(), 0, 1e-6 * speed) << which;
        EXPECT_NEAR(yaw_rate(response), 0, 1e-6) << which;
        EXPECT_NEAR(response.impacts[0].impulse, kMass * (1 + e) * speed, 0.004 * kMass * speed);
      }
}

TEST(Rebound, AVerticalEdgeTurnsTheBlockAsTheImpulseAtItSays) {
  // J = (1 + e) v / (1 / m + a^2 / I): the edge's lever arm a is about z.
  for (double yaw : {0.2, 0.4, 0.9})
    for (double e : {0.2, 0.5, 0.9})
      for (double speed : {0.2, 0.8, 2.0}) {
        Scene scene = sliding({speed, 0, 0});
        scene.items[0].initial.yaw = yaw;
        const double reach = 0.5 * (kSize.x() * std::cos(yaw) + kSize.y() * std::sin(yaw));
        blocks::add_wall(scene, reach + kGap, {.stiffness = 1e9, .restitution = e, .friction = 0});
        const Response response = run(scene, 1.1 * kGap);
        const double arm = 0.5 * (kSize.x() * std::sin(yaw) - kSize.y() * std::cos(yaw));
        const double impulse = (1 + e) * speed / (1 / kMass + arm * arm / yaw_inertia());
        const std::string which = "yaw " + std::to_string(yaw) + ", e " + std::to_string(e) + ", " +
                                  std::to_string(speed);
        ASSERT_GE(response.impacts.size(), 1u) << which;
        // They touch for 1 ms or less and the block turns at up to 10 rad/m times its speed: by
        // 1e-2 rad s/m. The arm changes by that times the half length along the wall, 0.3 m: at
        // 2 m/s by 3 mm.
        EXPECT_NEAR(response.items[0].history.back().velocity.x(), speed - impulse / kMass,
                    0.01 * speed)
            << which;
        EXPECT_NEAR(yaw_rate(response), impulse * arm / yaw_inertia(), 0.05 * speed) << which;
      }
}

/// A vertical edge or curve that the block's front meets at (front, y).
RoomShape obstacle(int kind, double y) {
  const double front = 0.5 * kSize.x() + kGap, radius = 0.15;
  RoomShape shape{"obstacle", "plaster", {front, y, 1.5}, Quaternion::Identity(), RoomBox{}};
  const Vector3 behind(radius, 0, 0);
  if (kind == 0) {
    shape.shape = RoomColumn{radius, 3};
    shape.position += behind;
  } else if (kind == 1) {
    shape.shape = RoomHull{{{0, 0, -1.5},
                            {0.2, 0.1, -1.5},
                            {0.2, -0.1, -1.5},
                            {0, 0, 1.5},
                            {0.2, 0.1, 1.5},
                            {0.2, -0.1, 1.5}}};
  } else {
    shape.shape = RoomBox{{std::sqrt(2.0) * radius, std::sqrt(2.0) * radius, 3}};
    shape.rotation = Quaternion(Eigen::AngleAxisd(std::numbers::pi / 4, Vector3::UnitZ()));
    shape.position += behind;
  }
  return shape;
}

TEST(Rebound, ColumnsHullsAndEdgesTurnTheBlockAsTheImpulseAtThemSays) {
  for (int kind : {0, 1, 2})
    for (double y : {0.0, 0.1, -0.15})
      for (double e : {0.2, 0.5, 0.9})
        for (double speed : {0.2, 0.8, 2.0}) {
          Scene scene = sliding({speed, 0, 0});
          scene.room = {obstacle(kind, y)};
          scene.pairs.push_back(
              {"steel", "plaster", {.stiffness = 1e9, .restitution = e, .friction = 0}});
          const Response response = run(scene, 1.1 * kGap);
          const double impulse = (1 + e) * speed / (1 / kMass + y * y / yaw_inertia());
          const std::string which = "obstacle " + std::to_string(kind) + " at " +
                                    std::to_string(y) + ", e " + std::to_string(e) + ", " +
                                    std::to_string(speed);
          ASSERT_GE(response.impacts.size(), 1u) << which;
          EXPECT_NEAR(response.items[0].history.back().velocity.x(), speed - impulse / kMass,
                      0.01 * speed)
              << which;
          EXPECT_NEAR(yaw_rate(response), impulse * y / yaw_inertia(), 0.05 * speed) << which;
        }
}

TEST(Rebound, AnEdgeOfTheBlockMeetsAColumnAwayFromItsAxis) {
  // A vertical edge of the block hits the column `aside` of the line through its axis: the normal
  // points from the axis to the edge.
  for (double aside : {0.0, 0.05, -0.08})
    for (double e : {0.2, 0.9})
      for (double speed : {0.2, 2.0}) {
        const double yaw = 0.7, radius = 0.15;
        Scene scene = sliding({speed, 0, 0});
        scene.items[0].initial.yaw = yaw;
        const Vector3 edge = turned(yaw, {0.5 * kSize.x(), -0.5 * kSize.y(), 0});
        const Vector3 normal =
            Vector3(-std::sqrt(radius * radius - aside * aside), aside, 0) / radius;
        const Vector3 touch = edge + Vector3(kGap, 0, 0);
        scene.room = {{"column", "plaster", touch - radius * normal + Vector3(0, 0, 1.5),
                       Quaternion::Identity(), RoomColumn{radius, 3}}};
        scene.pairs.push_back(
            {"steel", "plaster", {.stiffness = 1e9, .restitution = e, .friction = 0}});
        const Response response = run(scene, 1.1 * kGap);
        const double arm = edge.cross(normal).z();
        const double impulse =
            (1 + e) * -speed * normal.x() / (1 / kMass + arm * arm / yaw_inertia());
        const std::string which = "aside " + std::to_string(aside) + ", e " + std::to_string(e) +
                                  ", " + std::to_string(speed);
        ASSERT_GE(response.impacts.size(), 1u) << which;
        const Vector3 expected = Vector3(speed, 0, 0) + impulse / kMass * normal;
        const Vector3& v = response.items[0].history.back().velocity;
        EXPECT_NEAR(v.x(), expected.x(), 0.02 * speed) << which;
        EXPECT_NEAR(v.y(), expected.y(), 0.02 * speed) << which;
      }
}

TEST(Rebound, FrictionTakesItsPartOfTheNormalImpulseAndNoMore) {
  // Guides keep the block from turning, so all points slide alike: J_t = mu J_n until sliding ends.
  Excitation excitation;
  for (int dof : {3, 4, 5}) excitation.fixture.guides[dof].kind = Guide::Kind::kHeld;
  for (double mu : {0.1, 0.4})
    for (double e : {0.2, 0.7})
      for (double along : {0.3, 1.5}) {
        const double speed = 0.8;
        Scene scene = sliding({speed, along, 0});
        blocks::add_wall(scene, 0.5 * kSize.x() + kGap, {.restitution = e, .friction = mu});
        // Sliding ends and begins inside a step: half of one part in 32 of its work, itself at most
        // an eighth of the energy, may be missing.
        const Response response = run(scene, 2.5 * kGap, excitation, 2e-3);
        const Vector3& v = response.items[0].history.back().velocity;
        const std::string which = "mu " + std::to_string(mu) + ", e " + std::to_string(e) +
                                  ", along " + std::to_string(along);
        EXPECT_NEAR(-v.x(), e * speed, 0.002 * speed) << which;
        const double taken = along - v.y(), most = mu * (1 + e) * speed;
        EXPECT_LE(taken, most * 1.004) << which;  // the normal impulse's, as above
        if (most < 0.8 * along) {
          EXPECT_NEAR(taken, most, 0.004 * most) << which;
        }
        EXPECT_LT(v.squaredNorm(), speed * speed + along * along) << which;
      }
}

/// A block that may move along x and turn about z, which meets springs at `across` (y of points on
/// its front) at 1 m/s: by Runge-Kutta.
struct Parted {
  double speed, yaw_rate, peak_force;
};
Parted parted(const std::vector<double>& across, double stiffness) {
  Parted result{};
  const auto rates = [&](const Eigen::Vector4d& s) {  // x, yaw and their rates
    Eigen::Vector4d r(s[2], s[3], 0, 0);
    for (double y : across) {
      const double force = stiffness * std::max(0.0, s[0] - y * s[1]);
      r[2] -= force / kMass;
      r[3] += y * force / yaw_inertia();
    }
    return r;
  };
  Eigen::Vector4d s(0, 0, 1, 0);
  const double h = 1e-6;
  for (int i = 0; i < 20000; ++i) {
    const Eigen::Vector4d a = rates(s), b = rates(s + 0.5 * h * a), c = rates(s + 0.5 * h * b);
    result.peak_force = std::max(result.peak_force, -kMass * a[2]);
    s += h / 6 * (a + 2 * b + 2 * c + rates(s + h * c));
  }
  result.speed = s[2];
  result.yaw_rate = s[3];
  return result;
}

/// Meets `wall`, whose face the front of the block reaches after kGap. Guides leave x and yaw free.
Response meet(const RoomBox& box, const Vector3& position, double roll, double speed,
              const ContactConstants& constants) {
  Excitation excitation;
  for (int dof : {1, 2, 3, 4}) excitation.fixture.guides[dof].kind = Guide::Kind::kHeld;
  Scene scene = sliding({speed, 0, 0});
  blocks::add_wall(scene, 0, constants);
  RoomShape& wall = scene.room.back();
  wall.shape = box;
  wall.position = position + Vector3(0.5 * (kSize.x() + box.size.x()) + kGap, 0, 0);
  wall.rotation = Quaternion(Eigen::AngleAxisd(roll, Vector3::UnitX()));
  return run(scene, 1.4 * kGap, excitation);
}

ContactConstants spring(double stiffness) {
  return {.kind = ContactConstants::Kind::kCompliant, .stiffness = stiffness, .friction = 0};
}

TEST(Rebound, ACornerBeyondTheEdgeOfTheWallCarriesNothing) {
  // The wall's lower edge runs at 45 degrees and leaves out the block's corner at y = -0.2, z = 0:
  // it cuts the outline of the front at (-0.1, 0) and (-0.2, 0.1). Five points are left.
  const RoomBox wall{{0.2, 3, 3}};
  const Vector3 center = Vector3(0, -0.1, 0) + 1.5 * Vector3(0, 1, 1).normalized();
  const double k = 1e7, roll = std::numbers::pi / 4;
  const Parted expected = parted({0.2, 0.2, -0.2, -0.2, -0.1}, k);
  const Parted with_corner = parted({0.2, 0.2, -0.2, -0.2}, k);
  const Parted three = parted({0.2, 0.2, -0.2}, k);
  ASSERT_GT(std::abs(with_corner.peak_force / expected.peak_force - 1), 0.05);
  ASSERT_GT(std::abs(three.peak_force / expected.peak_force - 1), 0.05);
  for (double speed : {0.2, 0.8, 2.0}) {
    const Response response = meet(wall, center, roll, speed, spring(k));
    ASSERT_EQ(response.impacts.size(), 1u);
    EXPECT_NEAR(response.impacts[0].peak_force, expected.peak_force * speed,
                0.01 * expected.peak_force * speed);
    EXPECT_NEAR(response.items[0].history.back().velocity.x(), expected.speed * speed,
                0.01 * speed);
    // Every point rebounds with the restitution stated, wherever it is: the face stays flat.
    for (double e : {0.2, 0.7}) {
      const Response flat = meet(wall, center, roll, speed, {.restitution = e, .friction = 0});
      EXPECT_NEAR(-flat.items[0].history.back().velocity.x(), e * speed, 0.01 * speed) << e;
      EXPECT_NEAR(yaw_rate(flat) * 0.5 * kSize.y(), 0, 0.01 * speed) << e;
    }
  }
}

TEST(Rebound, AWallThatCoversLessThanHalfOfTheFrontTurnsTheBlock) {
  // It begins at y = 0.05: points at 0.05 and 0.2, twice each.
  const double k = 1e8;
  const Parted expected = parted({0.05, 0.05, 0.2, 0.2}, k);
  ASSERT_GT(expected.yaw_rate, 2);
  for (double speed : {0.2, 0.8, 2.0}) {
    const Response response = meet({{0.2, 3, 3}}, {0, 1.55, 1.5}, 0, speed, spring(k));
    EXPECT_NEAR(response.items[0].history.back().velocity.x(), expected.speed * speed,
                0.01 * speed);
    EXPECT_NEAR(yaw_rate(response), expected.yaw_rate * speed, 0.02 * expected.yaw_rate * speed);
  }
}

TEST(Rebound, ASpringTouchesForPiRootOfMassOverStiffnessAtTheDefaultStep) {
  // Four corners share the load: k is that of each.
  for (double k : {5e4, 4e5, 2e6})
    for (double speed : {0.2, 0.8, 2.0}) {
      const double omega = std::sqrt(4 * k / kMass);
      Scene scene = sliding({speed, 0, 0});
      blocks::add_wall(scene, 0.5 * kSize.x() + kGap,
                       {.kind = ContactConstants::Kind::kCompliant, .stiffness = k, .friction = 0});
      const Response response = run(scene, 2.5 * kGap);
      ASSERT_EQ(response.impacts.size(), 1u);
      const Impact& impact = response.impacts[0];
      // A stage ends up to half a step's phase off the peak: (pi / 32)^2 / 2 = 0.5 %.
      EXPECT_NEAR(impact.duration, std::numbers::pi / omega, 0.01 * std::numbers::pi / omega);
      EXPECT_NEAR(impact.peak_force, kMass * speed * omega, 0.01 * kMass * speed * omega);
      EXPECT_NEAR(-response.items[0].history.back().velocity.x(), speed, 0.002 * speed);
    }
}

}  // namespace
}  // namespace gurney
