#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <random>

#include "engine/bullet/convert.h"
#include "engine/bullet/multibody_item.h"
#include "engine/solver/mechanism.h"
#include "studies/verification/scenes/small_scenes.h"
#include "tests/support/caster_matrices.h"

// The mechanics of engine/caster/caster_dynamics.h (mass matrix, bias, contact Jacobian) against
// Bullet's own reduced-coordinate multibody (Featherstone's articulated-body algorithm), at random
// states.
namespace gurney {
namespace {

struct World {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btMultiBodyConstraintSolver solver;
  btMultiBodyDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};
};

Scene odd_scene() {
  Scene scene = scene_of(small::trolley({10, 105, 200, 295}, small::bare_tread(3e5, 1e5)));
  EquipmentModel& item = scene.items[0].model;
  Matrix3 inertia;
  inertia << 7, 0.8, -0.5, 0.8, 9, 0.6, -0.5, 0.6, 8;
  item.chassis_inertia = inertia;
  item.chassis_center_of_mass = {0.05, -0.03, 0.5};
  item.payloads = {{"p", 13.6, {0.2, 0.1, 0.9}, solid_box_inertia(13.6, {0.3, 0.2, 0.1})}};
  for (Caster& c : item.casters) {
    // Heavy, lopsided forks: an error in any term shows.
    c.fork_mass = 1.5;
    c.fork_center_of_mass = {-0.02, 0.006, -0.04};
    c.fork_inertia << 4e-3, 3e-4, -2e-4, 3e-4, 5e-3, 1e-4, -2e-4, 1e-4, 3e-3;
    c.wheel_mass = 2;
    c.wheel_axial_inertia = 3e-3;
    c.wheel_transverse_inertia = 1.7e-3;
    c.tread.patch_width = 0.02;
  }
  item.casters[2].swivels = false;
  return scene;
}

class BulletMechanics : public testing::Test {
 protected:
  static constexpr int kJoints = 8;
  static constexpr int kSize = 6 + kJoints;
  using Vector = Eigen::Matrix<double, kSize, 1>;

  BulletMechanics()
      : scene_(odd_scene()),
        mechanism_(scene_, 0),
        item_(scene_.items[0].model, mechanism_, world_.world) {}

  double draw() { return std::ldexp(static_cast<double>(random_()), -31) - 1; }
  Vector3 draw3(double size) { return size * Vector3(draw(), draw(), draw()); }

  /// A tilted, turning item with turning casters.
  State random_state() {
    State state;
    state.position = draw3(1) + Vector3(0, 0, 0.5);
    state.rotation = Quaternion(1, 0.3 * draw(), 0.3 * draw(), draw()).normalized();
    state.velocity.chassis << draw3(2), draw3(3);
    for (std::size_t i = 0; i < 4; ++i) {
      state.casters[i].swivel_angle = scene_.items[0].model.casters[i].heading;
      state.velocity.joints[i] = {8 * draw(), 40 * draw()};
      if (mechanism_.casters[i].swivels()) {
        state.casters[i].swivel_angle += 3 * draw();
      } else {
        state.velocity.joints[i][0] = 0;
      }
      state.casters[i].axle_angle = 3 * draw();
    }
    return state;
  }

  void evaluate(const State& state) {
    for (std::size_t i = 0; i < 4; ++i)
      casters_[i] =
          caster_matrices(mechanism_.casters[i], state.pose(), state.casters[i].swivel_angle,
                          state.velocity.chassis, state.velocity.joints[i], gravity_);
  }

  static Vector velocity_of(const State& state) {
    Vector v;
    v.head<6>() = state.velocity.chassis;
    for (int i = 0; i < 4; ++i)
      v.segment<2>(6 + 2 * i) = state.velocity.joints[static_cast<std::size_t>(i)];
    return v;
  }

  Scene scene_;
  Mechanism mechanism_;
  World world_;
  MultibodyItem item_;
  std::mt19937 random_{7};
  Vector3 gravity_{0.7, -1.3, -9.0};
  std::array<CasterMatrices, 4> casters_;
};

TEST_F(BulletMechanics, AccelerationsAgreeUnderRandomForces) {
  btAlignedObjectArray<btScalar> scratch_r;
  btAlignedObjectArray<btVector3> scratch_v;
  btAlignedObjectArray<btMatrix3x3> scratch_m;
  for (int trial = 0; trial < 50; ++trial) {
    const State state = random_state();
    evaluate(state);
    item_.set(state);
    btMultiBody& body = item_.body();
    body.clearForcesAndTorques();
    body.addBaseForce(to_bullet(Vector3(mechanism_.chassis.mass * gravity_)));

    Eigen::Matrix<double, kSize, kSize> mass = Eigen::Matrix<double, kSize, kSize>::Zero();
    Vector force = Vector::Zero();
    const auto& chassis = mechanism_.chassis;
    const Matrix3 rotation = state.rotation.toRotationMatrix();
    const Matrix3 inertia = rotation * chassis.inertia * rotation.transpose();
    const Vector3 spin = state.velocity.chassis.tail<3>();
    mass.diagonal().head<3>().setConstant(chassis.mass);
    mass.block<3, 3>(3, 3) = inertia;
    force.head<3>() = chassis.mass * gravity_;
    force.segment<3>(3) = -spin.cross(inertia * spin);
    const Vector3 push = draw3(50), twist = draw3(10);
    body.addBaseForce(to_bullet(push));
    body.addBaseTorque(to_bullet(twist));
    force.head<6>() += (Vector6() << push, twist).finished();

    for (int i = 0; i < 4; ++i) {
      const auto caster = static_cast<std::size_t>(i);
      const CasterMatrices& g = casters_[caster];
      const int joint = 6 + 2 * i;
      mass.topLeftCorner<6, 6>() += g.mass_chassis;
      mass.block<6, 2>(0, joint) = g.mass_coupling;
      mass.block<2, 6>(joint, 0) = g.mass_coupling.transpose();
      mass.block<2, 2>(joint, joint) = g.mass_joints;
      Vector5 contact;
      contact << draw3(30), 20 * draw(), draw();
      const double swivel = mechanism_.casters[caster].swivels() ? draw() : 0, axle = draw();
      force.head<6>() += g.jacobian_chassis.transpose() * contact - g.bias_chassis;
      force.segment<2>(joint) +=
          g.jacobian_joints.transpose() * contact - g.bias_joints + Eigen::Vector2d(swivel, axle);

      const int fork = 2 * i, wheel = 2 * i + 1;
      const Caster& c = scene_.items[0].model.casters[caster];
      body.addLinkForce(fork, to_bullet(Vector3(c.fork_mass * gravity_)));
      body.addLinkForce(wheel, to_bullet(Vector3(c.wheel_mass * gravity_ + contact.head<3>())));
      const Vector3 moment =
          (g.contact - g.wheel_center).cross(contact.head<3>().eval()) +
          mechanism_.casters[caster].tread().spin_radius() * contact[3] * Vector3::UnitZ() +
          contact[4] * g.axle_level;
      body.addLinkTorque(wheel, to_bullet(moment));
      if (swivel != 0) body.addJointTorque(fork, swivel);
      body.addJointTorque(wheel, axle);
    }
    const Vector expected = mass.partialPivLu().solve(force);

    // Bullet adds the acceleration, times this step, to the velocities.
    body.computeAccelerationsArticulatedBodyAlgorithmMultiDof(1, scratch_r, scratch_v, scratch_m,
                                                              false, false, false);
    State after = state;
    item_.get(after);
    const Vector found = velocity_of(after) - velocity_of(state);
    EXPECT_LT((found - expected).norm(), 1e-9 * expected.norm()) << "trial " << trial;
    for (int k = 0; k < kSize; ++k)
      EXPECT_NEAR(found[k], expected[k], 1e-9 * expected.norm()) << "coordinate " << k;
  }
}

TEST_F(BulletMechanics, ContactJacobianAgrees) {
  btAlignedObjectArray<btScalar> scratch_r;
  btAlignedObjectArray<btVector3> scratch_v;
  btAlignedObjectArray<btMatrix3x3> scratch_m;
  for (int trial = 0; trial < 20; ++trial) {
    const State state = random_state();
    evaluate(state);
    item_.set(state);
    const int dofs = item_.body().getNumDofs();
    ASSERT_EQ(dofs, 7);  // one caster does not swivel
    for (int i = 0; i < 4; ++i) {
      const auto caster = static_cast<std::size_t>(i);
      const CasterMatrices& g = casters_[caster];
      const Vector3 point = state.position + g.contact;
      for (int axis = 0; axis < 3; ++axis) {
        std::vector<btScalar> row(static_cast<std::size_t>(6 + dofs), 0.0);
        item_.body().fillConstraintJacobianMultiDof(2 * i + 1, to_bullet(point), btVector3(0, 0, 0),
                                                    to_bullet(Vector3(Vector3::Unit(axis))),
                                                    row.data(), scratch_r, scratch_v, scratch_m);
        for (int k = 0; k < 3; ++k) {
          EXPECT_NEAR(row[static_cast<std::size_t>(k)], g.jacobian_chassis(axis, 3 + k), 1e-12);
          EXPECT_NEAR(row[static_cast<std::size_t>(3 + k)], g.jacobian_chassis(axis, k), 1e-12);
        }
        const auto joint_column = [&](int link) {
          return 6 + static_cast<std::size_t>(item_.body().getLink(link).m_dofOffset);
        };
        if (mechanism_.casters[caster].swivels()) {
          EXPECT_NEAR(row[joint_column(2 * i)], g.jacobian_joints(axis, 0), 1e-12);
        }
        EXPECT_NEAR(row[joint_column(2 * i + 1)], g.jacobian_joints(axis, 1), 1e-12);
      }
    }
  }
}

}  // namespace
}  // namespace gurney
