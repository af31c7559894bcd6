#include "engine/solver/joint_law.h"

#include <gtest/gtest.h>

#include "engine/solver/assembly.h"
#include "studies/verification/scenes/blocks.h"

namespace gurney {
namespace {

/// A block of 2 kg that hangs on one of 100 kg, 1.5 m above the floor.
Scene bag_on_a_ball() {
  Scene scene = blocks::block(100, {1, 1, 1}, {});
  PlacedItem bag = blocks::block(2, Vector3::Constant(0.3), {}).items[0];
  bag.name = "bag";
  bag.model.chassis_center_of_mass = bag.model.shape[0].center = Vector3(0, 0, 1.5);
  scene.items.push_back(bag);
  scene.pairs.push_back({"steel", "steel", {}});
  Joint ball;
  ball.kind = Joint::Kind::kBall;
  ball.base = 0;
  ball.part = 1;
  ball.point = Vector3(0, 0, 1.5);
  ball.axis = Vector3(0.6, 0, 0.8);
  scene.joints = {ball};
  return scene;
}

// -c (w_part - w_base) on the part, about any axis and however far it has turned from its base.
TEST(JointLaw, ADampedBallTakesTheRelativeAngularVelocity) {
  Scene scene = bag_on_a_ball();
  scene.joints[0].damping = 0.7;
  const Assembly assembly(scene);
  const JointLaw& ball = assembly.joints[0];
  const Vector3 w(0.3, -1.1, 2.0), w_base(-0.4, 0.2, 0.9);
  for (const double turned : {0.0, 1.0, 3.0}) {
    const Pose base{Vector3::Zero(),
                    rotated({0.2, 0.1, -0.4}, Quaternion::Identity()).toRotationMatrix()};
    const Quaternion far = rotated(turned * Vector3(0.36, 0.48, 0.8), Quaternion(base.rotation));
    JointLaw::Stage stage{0.001, ball.rows(base, {Vector3::Zero(), far.toRotationMatrix()}, 0), {}};
    Vector6 of_part, of_base;
    of_part << Vector3::Zero(), w;
    of_base << Vector3::Zero(), w_base;
    Vector3 torque = Vector3::Zero();
    for (std::size_t i = 3; i < stage.rows.count; ++i) {  // behind the three of the point
      const JointLaw::Row& row = stage.rows.rows[i];
      torque -= ball.force(stage, i, row.rate(of_part, of_base)).force * row.part.tail<3>();
    }
    EXPECT_LT((torque + 0.7 * (w - w_base)).norm(), 1e-12) << turned;
  }
}

// Rates of the rotation vector that a sprung ball has, about axes that are not its own: against central differences of
// the angles, whose error is h^2 / 6 of their third derivative, some 1e-9, and the rounding 1e-16 / h.
TEST(JointLaw, RatesOfASprungBallAreThoseOfItsAngles) {
  constexpr double kH = 2e-5;
  Scene scene = bag_on_a_ball();
  scene.joints[0].stiffness = 5;
  const Assembly assembly(scene);
  const JointLaw& ball = assembly.joints[0];
  const Vector3 w(0.3, -1.1, 2.0), w_base(-0.4, 0.2, 0.9);
  Vector6 of_part, of_base;
  of_part << Vector3::Zero(), w;
  of_base << Vector3::Zero(), w_base;
  for (const double turned : {5e-4, 0.5, 1.5, 2.5}) {
    const Quaternion base = rotated({0.2, 0.1, -0.4}, Quaternion::Identity()),
                     part = rotated(turned * Vector3(0.36, 0.48, 0.8), base);
    const auto rows_at = [&](double time) {
      return ball.rows({Vector3::Zero(), rotated(time * w_base, base).toRotationMatrix()},
                       {Vector3::Zero(), rotated(time * w, part).toRotationMatrix()}, 0);
    };
    const auto before = rows_at(-kH), now = rows_at(0), after = rows_at(kH);
    ASSERT_EQ(now.count, 6u);
    for (std::size_t i = 3; i < 6; ++i)
      EXPECT_NEAR(now.rows[i].rate(of_part, of_base),
                  (after.rows[i].value - before.rows[i].value) / (2 * kH), 1e-8)
          << turned << " " << i;
  }
}

// A flexible joint springs with k theta across its axis. About it it holds the bag, whose inertia is 2 kg 0.3^2 / 6,
// as stiffly as turns it with 1e4 rad/s.
TEST(JointLaw, AFlexibleJointSpringsAcrossItsAxisAndHoldsAboutIt) {
  constexpr double kStiffness = 5, kTurn = 0.01;
  Scene scene = bag_on_a_ball();
  scene.joints[0].kind = Joint::Kind::kFlexible;
  scene.joints[0].stiffness = kStiffness;
  const Assembly assembly(scene);
  const JointLaw& joint = assembly.joints[0];
  const auto torque_at = [&](const Vector3& about) {
    const Pose turned{Vector3::Zero(),
                      rotated(kTurn * about, Quaternion::Identity()).toRotationMatrix()};
    JointLaw::Stage stage{0.001, joint.rows({Vector3::Zero(), Matrix3::Identity()}, turned, 0), {}};
    double torque = 0;
    for (std::size_t i = 3; i < stage.rows.count; ++i)
      torque -= joint.force(stage, i, 0).force * stage.rows.rows[i].part.tail<3>().dot(about);
    return torque;
  };
  EXPECT_NEAR(torque_at({0, 1, 0}), -kStiffness * kTurn, 1e-12);
  EXPECT_NEAR(torque_at({0.8, 0, -0.6}), -kStiffness * kTurn, 1e-12);
  const double held = 2 * 0.3 * 0.3 / 6 * 1e8 * kTurn;
  EXPECT_NEAR(torque_at({0.6, 0, 0.8}), -held, 1e-9 * held);
}

}  // namespace
}  // namespace gurney
