#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "engine/bullet/convert.h"
#include "engine/run/simulate.h"
#include "studies/verification/scenes/blocks.h"

// An arm of three joints on a cart that it moves, against the articulated-body algorithm of Bullet in
// coordinates of the joints (Featherstone), integrated by a Runge-Kutta method of fourth order.
namespace gurney {
namespace {

constexpr double kGravity = 9.80665, kCart = 30, kCartSpring = 900, kDuration = 2;

/// A uniform box on a hinge.
struct Link {
  double mass;
  Vector3 size, center, point, axis;  ///< in item axes, where all hinges are at 0
  double stiffness, damping;
};

const std::array<Link, 3> kArm = {{
    {4, {0.1, 0.6, 0.1}, {0, 0.3, 1.2}, {0, 0, 1.2}, Vector3::UnitZ(), 6, 0.3},
    {3, {0.1, 0.1, 0.5}, {0, 0.6, 1.5}, {0, 0.6, 1.2}, Vector3(0.6, 0, 0.8), 60, 0.2},
    {2, {0.4, 0.1, 0.2}, {0.2, 0.6, 1.8}, {0, 0.6, 1.75}, Vector3::UnitY(), 20, 0.1},
}};

/// In all three directions, and between samples linear. Gravity is a part of it and sets in at the start: the arm
/// would not come to rest before where all hinges are at 0.
FloorMotion floor_motion(double slowness) {
  constexpr double kStep = 0.002;
  const auto count = static_cast<Eigen::Index>(std::lround(kDuration / kStep)) + 2;
  Eigen::Matrix3Xd a(3, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double phase = 2 * std::numbers::pi * kStep * static_cast<double>(i);
    a.col(i) << 3 * std::sin(0.9 * phase), 2 * std::sin(1.3 * phase),
        kGravity + 1.5 * std::sin(2.1 * phase);
  }
  return {slowness * kStep, a / (slowness * slowness)};
}

Scene cart_with_arm(double slowness) {
  Scene scene = blocks::block(kCart, {1, 1, 1}, {});
  scene.items[0].name = "cart";
  scene.gravity = 0;
  scene.pairs[0].constants.friction = 0;
  scene.pairs.push_back({"steel", "steel", {}});
  for (Guide& guide : scene.items[0].fixture.guides) guide.kind = Guide::Kind::kHeld;
  scene.items[0].fixture.guides[0] = {Guide::Kind::kSpring, 0, kCartSpring / (slowness * slowness),
                                      0};
  for (const Link& link : kArm) {
    PlacedItem item = blocks::block(link.mass, link.size, {}).items[0];
    item.name = fmt::format("link {}", scene.items.size());
    item.model.chassis_center_of_mass = item.model.shape[0].center = link.center;
    item.model.marked_points.clear();
    Joint joint;
    joint.kind = Joint::Kind::kHinge;
    joint.name = item.name;
    joint.base = scene.items.size() - 1;
    joint.part = scene.items.size();
    joint.point = link.point;
    joint.axis = link.axis;
    joint.stiffness = link.stiffness / (slowness * slowness);
    joint.damping = link.damping / slowness;
    scene.items.push_back(item);
    scene.joints.push_back(joint);
  }
  return scene;
}

/// The same as Bullet holds it: a cart on a slider, and the links.
class BulletArm {
 public:
  using Y = Eigen::Matrix<double, 8, 1>;  ///< coordinates of cart and hinges, and their rates

  BulletArm() : body_(4, 1, btVector3(1, 1, 1), true, false) {
    body_.setLinearDamping(0);
    body_.setAngularDamping(0);
    body_.setUseGyroTerm(true);
    body_.setMaxCoordinateVelocity(1e30);
    const btQuaternion same(0, 0, 0, 1);
    body_.setupPrismatic(0, kCart, btVector3(1, 1, 1), -1, same, btVector3(1, 0, 0),
                         btVector3(0, 0, 0.5), btVector3(0, 0, 0), true);
    Vector3 carrier(0, 0, 0.5);
    for (int i = 0; i < 3; ++i) {
      const Link& link = kArm[static_cast<std::size_t>(i)];
      const Matrix3 inertia = solid_box_inertia(link.mass, link.size);
      body_.setupRevolute(i + 1, link.mass, to_bullet(Vector3(inertia.diagonal())), i, same,
                          to_bullet(link.axis), to_bullet(Vector3(link.point - carrier)),
                          to_bullet(Vector3(link.center - link.point)), true);
      carrier = link.center;
    }
    body_.finalizeMultiDof();
  }

  Y rates(const Vector3& floor, const Y& y) {
    for (int i = 0; i < 4; ++i) {
      body_.setJointPos(i, y[i]);
      body_.setJointVel(i, y[4 + i]);
    }
    body_.clearForcesAndTorques();
    body_.addJointTorque(0, -kCartSpring * y[0]);
    body_.addLinkForce(0, to_bullet(Vector3(-kCart * floor)));
    for (int i = 1; i < 4; ++i) {
      const Link& link = kArm[static_cast<std::size_t>(i - 1)];
      body_.addLinkForce(i, to_bullet(Vector3(-link.mass * floor)));
      body_.addJointTorque(i, -link.stiffness * y[i] - link.damping * y[4 + i]);
    }
    // Bullet adds the acceleration, times this step, to the velocities.
    body_.computeAccelerationsArticulatedBodyAlgorithmMultiDof(1, scratch_r_, scratch_v_,
                                                               scratch_m_, false, false, false);
    Y rate;
    for (int i = 0; i < 4; ++i) {
      rate[i] = y[4 + i];
      rate[4 + i] = body_.getJointVel(i) - y[4 + i];
    }
    return rate;
  }

 private:
  btMultiBody body_;
  btAlignedObjectArray<btScalar> scratch_r_;
  btAlignedObjectArray<btVector3> scratch_v_;
  btAlignedObjectArray<btMatrix3x3> scratch_m_;
};

/// At the end of the run.
BulletArm::Y integrated(const FloorMotion& floor, int steps) {
  BulletArm arm;
  BulletArm::Y y = BulletArm::Y::Zero();
  const double h = kDuration / steps;
  for (int i = 0; i < steps; ++i) {
    const double t = h * i;
    const auto at = [&](double s, const BulletArm::Y& state) {
      return arm.rates(floor.acceleration_at(t + s), state);
    };
    const BulletArm::Y k1 = at(0, y), k2 = at(h / 2, y + h / 2 * k1),
                       k3 = at(h / 2, y + h / 2 * k2), k4 = at(h, y + h * k3);
    y += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return y;
}

/// What is compared at the end: the cart's place and the axes of each link, as rotations from the reference.
using Errors = Eigen::Matrix<double, 10, 1>;

Errors error_of(const Response& r, const BulletArm::Y& y) {
  Errors error;
  error[0] = r.items[0].history.back().displacement.x() - y[0];
  Quaternion reference = Quaternion::Identity();
  for (int i = 0; i < 3; ++i) {
    const auto link = static_cast<std::size_t>(i);
    reference = reference * Quaternion(Eigen::AngleAxisd(y[i + 1], kArm[link].axis));
    error.segment<3>(1 + 3 * i) =
        2 * (reference.conjugate() * r.items[link + 1].history.back().orientation).vec();
  }
  return error;
}

// The method is of second order: half a step has a quarter of the error. Its extrapolation to a step of zero,
// (4 e(h / 2) - e(h)) / 3, leaves what is no error of the integration: the joints yield, by a / omega_c^2 at an
// acceleration a (joint_law.h), some 0.1 um here, which the motion amplifies. The same motion s times as slow has
// s^-2 times the accelerations and so s^-2 times that yield: Bullet's joints are the limit. The reference is
// converged: half its steps change it by 2^4 times its error.
TEST(MultibodyParts, ArmOfThreeJointsOnACartThatItMoves) {
  const BulletArm::Y y = integrated(floor_motion(1), 8000),
                     coarser = integrated(floor_motion(1), 4000);
  ASSERT_LT((y - coarser).norm(), 1e-8);
  for (int i = 1; i < 4; ++i) ASSERT_GT(std::abs(y[i]), 0.02) << "hinge " << i << " hardly turns";
  const auto left = [&](double slowness) {
    std::array<Errors, 2> error;
    for (std::size_t k = 0; k < 2; ++k) {
      const auto settings = blocks::run_for(slowness * kDuration,
                                            slowness * (k == 0 ? 0.002 : 0.001), slowness * 0.1);
      const Response r = simulate(cart_with_arm(slowness), floor_motion(slowness), settings);
      EXPECT_EQ(r.outcome, Outcome::kStopped) << r.cause;
      error[k] = error_of(r, y);
    }
    EXPECT_LT(error[1].norm(), 1e-4);
    EXPECT_NEAR(error[0].norm() / error[1].norm(), 4, 1);
    return ((4 * error[1] - error[0]) / 3).norm();
  };
  const double fast = left(1), slow = left(3);
  EXPECT_LT(fast, 1e-5);
  EXPECT_NEAR(fast / slow, 9, 3) << fast << " and " << slow;
}

}  // namespace
}  // namespace gurney
