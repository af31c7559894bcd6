#include "engine/solver/item_stage.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "engine/base/units.h"
#include "studies/verification/scenes/blocks.h"
#include "studies/verification/scenes/small_scenes.h"

namespace gurney {
namespace {

constexpr double kTau = 0.003, kMass = 10, kG = kStandardGravity;
const Vector3 kSize(0.5, 0.4, 0.6);

/// A block in the air, that turns.
struct Block {
  Scene scene;
  Mechanism mechanism;
  State start;
  ItemStage stage;

  explicit Block(const Fixture& fixture = {})
      : scene(fixed(fixture)), mechanism(scene, 0), stage(mechanism) {
    start.position = {1, 2, 3};
    start.velocity.chassis << 0.1, 0.2, 0.3, 0, 0, 2;
  }
  static Scene fixed(const Fixture& fixture) {
    Scene scene = blocks::block(kMass, kSize, {});
    scene.items[0].fixture = fixture;
    return scene;
  }
  ItemStage::Input input() const {
    ItemStage::Input input{&start, kTau, {}, {}};
    input.loads.start = &start.loads;
    return input;
  }
  double residual(const Velocity& v) {
    stage.update_geometry(input(), v, true);
    stage.begin_forces(input(), v);
    return stage.end_forces(input(), v);
  }
};

/// After tau in free fall; about a principal axis the rotation goes on.
Velocity falling(const Block& block) {
  Velocity v = block.start.velocity;
  v.chassis[2] -= kG * kTau;
  return v;
}

TEST(ItemStage, HasNoResidualInFreeFallAndTheWeightsElse) {
  Block block;
  EXPECT_NEAR(block.residual(falling(block)), 0, 1e-15);
  EXPECT_NEAR(block.residual(block.start.velocity), 1, 1e-13);
  Velocity v = falling(block);
  v.chassis[0] += 0.25 * kG * kTau;
  EXPECT_NEAR(block.residual(v), 0.25, 1e-13);
}

TEST(ItemStage, AFloorThatFallsWithGravityLeavesNoWeight) {
  Block block;
  ItemStage::Input input = block.input();
  input.floor.acceleration = {0, 0, -kG};
  block.stage.update_geometry(input, block.start.velocity, true);
  block.stage.begin_forces(input, block.start.velocity);
  EXPECT_NEAR(block.stage.end_forces(input, block.start.velocity), 0, 1e-15);
}

// Newton's matrix of a free body is its inertia, in floor axes at the end of the stage.
TEST(ItemStage, ItsMatrixIsTheInertia) {
  Block block;
  block.residual(falling(block));
  block.stage.begin_matrix();
  block.stage.eliminate();
  block.stage.eliminate_residual();
  Matrix6 inertia = Matrix6::Zero();
  inertia.diagonal().head<3>().setConstant(kMass);
  const Matrix3 turned = Eigen::AngleAxisd(2 * kTau, Vector3::UnitZ()).toRotationMatrix();
  inertia.bottomRightCorner<3, 3>() = turned * solid_box_inertia(kMass, kSize) * turned.transpose();
  EXPECT_LT((block.stage.matrix() - inertia).norm(), 1e-12);
  EXPECT_LT(block.stage.right_side().norm(), 1e-12);
}

// A force f at x, of slope D, adds J' f and J' D J with J = (1, -x cross).
TEST(ItemStage, AddsTheForceAndTheSlopeOfAContact) {
  Block block;
  const Vector3 x(0.1, -0.2, 0.3), f(5, -6, 7);
  Matrix3 slope;
  slope << 3, 1, 0, 1, 4, 0, 0, 0, 5;
  ItemStage::Matrix36 jacobian;
  jacobian << 1, 0, 0, 0, x.z(), -x.y(), 0, 1, 0, -x.z(), 0, x.x(), 0, 0, 1, x.y(), -x.x(), 0;
  const Velocity v = falling(block);
  block.residual(v);
  block.stage.begin_matrix();
  block.stage.eliminate();
  block.stage.eliminate_residual();
  const Matrix6 without = block.stage.matrix();

  block.stage.begin_forces(block.input(), v);
  block.stage.add_contact_force(-1, jacobian, ItemStage::Matrix32::Zero(), f);
  block.stage.end_forces(block.input(), v);
  block.stage.begin_matrix();
  block.stage.add_slope(kTau * slope_between(slope, x, x));
  block.stage.eliminate();
  block.stage.eliminate_residual();
  Vector6 wrench;
  wrench << f, x.cross(f);
  EXPECT_LT((block.stage.right_side() - kTau * wrench).norm(), 1e-12);
  const Matrix6 added = kTau * jacobian.transpose() * slope * jacobian;
  EXPECT_LT((block.stage.matrix() - without - added).norm(), 1e-12);
}

// Of a slope that is not symmetric, as that of friction, between two points.
TEST(ItemStage, CouplesTwoChassisByTheSlopeOfTheirContact) {
  const Vector3 a(0.1, -0.2, 0.3), b(-0.4, 0.5, 0.7);
  Matrix3 slope;
  slope << 3, 1, 2, -1, 4, 0.5, 0, 0.3, 5;
  const auto jacobian = [](const Vector3& p) {
    ItemStage::Matrix36 J;
    J << 1, 0, 0, 0, p.z(), -p.y(), 0, 1, 0, -p.z(), 0, p.x(), 0, 0, 1, p.y(), -p.x(), 0;
    return J;
  };
  const Matrix6 expected = jacobian(a).transpose() * slope * jacobian(b);
  EXPECT_LT((slope_between(slope, a, b) - expected).norm(), 1e-14);
}

TEST(ItemStage, AGuideThatHoldsTakesItsDirectionOut) {
  Fixture fixture;
  fixture.guides[2] = {Guide::Kind::kVelocity, 0.7, 0, 0};
  Block block(fixture);
  EXPECT_TRUE(block.stage.constrained(2));
  EXPECT_FALSE(block.stage.constrained(0));
  Velocity v = block.start.velocity;
  block.residual(v);
  block.stage.begin_matrix();
  block.stage.eliminate();
  block.stage.eliminate_residual();
  block.stage.apply(block.stage.matrix().partialPivLu().solve(block.stage.right_side()), v);
  EXPECT_NEAR(v.chassis[2], 0.7, 1e-15);
  EXPECT_NEAR(v.chassis[0], 0.1, 1e-15);
}

TEST(ItemStage, MovesOnByTheVelocityAtItsEnd) {
  Block block;
  const Velocity v = falling(block);
  block.residual(v);
  State end = block.start;
  ItemStage::Output out;
  block.stage.finish(block.input(), v, end, out);
  EXPECT_LT((end.position - block.start.position - kTau * v.chassis.head<3>()).norm(), 1e-15);
  EXPECT_NEAR(Eigen::AngleAxisd(end.rotation).angle(), 2 * kTau, 1e-12);
  EXPECT_NEAR(out.acceleration.chassis[2], -kG, 1e-12);
  EXPECT_NEAR(out.spring_rates, kMass * kG * kG, 1e-10);  // a' M a
  EXPECT_EQ(out.power.contact_loss, 0);
}

TEST(ItemStage, KnowsHowFarAVelocityTurnsItFromItsGeometry) {
  Block block;
  block.residual(block.start.velocity);
  Velocity v = block.start.velocity;
  v.chassis[0] += 5;  // moves and does not turn
  EXPECT_EQ(block.stage.geometry_error(v), 0);
  v.chassis[3] += 0.4;
  EXPECT_NEAR(block.stage.geometry_error(v), 0.4 * kTau, 1e-15);
}

// The joints are eliminated: with them put back, Newton's step solves every equation of a trolley
// on springs, of whatever start, as its forces are linear as long as wheels stay on the floor.
TEST(ItemStage, ItsStepSolvesTheJointsToo) {
  Tread tread = small::bare_tread(1e5, 1e5);
  tread.patch_width = 0.03;  // its spin has a part in the matrix, too
  const Scene scene = scene_of(small::trolley({20, 80, 140, -60}, tread));
  const Mechanism mechanism(scene, 0);
  State start = mechanism.placed({});
  start.position.z() -= 2e-3;
  start.loads = mechanism.loads.initial_state();
  ItemStage::Input input{&start, kTau, {}, {}};
  input.loads.start = &start.loads;
  ItemStage stage(mechanism);
  Velocity v = start.velocity;
  v.chassis[0] = 1e-4;
  stage.update_geometry(input, v, true);
  stage.begin_forces(input, v);
  EXPECT_GT(stage.end_forces(input, v), 1e-2);
  stage.begin_matrix();
  stage.eliminate();
  stage.eliminate_residual();
  stage.apply(stage.matrix().partialPivLu().solve(stage.right_side()), v);
  stage.begin_forces(input, v);
  EXPECT_LT(stage.end_forces(input, v), 1e-10);
}

}  // namespace
}  // namespace gurney
