#include "engine/solver/stage_solver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

#include "engine/solver/quadrature.h"
#include "studies/verification/scenes/blocks.h"

// Blocks without weight that a compliant wall, or each other, push at the height of their centres.
namespace gurney {
namespace {

constexpr double kStiffness = 4e4, kMass = 10, kTau = 0.002;  // [N/m], [kg], [s]
constexpr double kShare = kTau * kTau * kStiffness / kMass;   // (tau omega)^2

ContactConstants spring(double friction = 0) {
  return {
      .kind = ContactConstants::Kind::kCompliant, .stiffness = kStiffness, .friction = friction};
}

Scene blocks_at_wall(std::size_t count, double friction = 0) {
  Scene scene = blocks::block(kMass, {0.5, 0.4, 0.6}, {});
  scene.items.resize(count, scene.items[0]);
  for (std::size_t i = 0; i < count; ++i) scene.items[i].name = i == 0 ? "first" : "second";
  scene.gravity = 0;
  blocks::add_wall(scene, 1, spring(friction));
  scene.pairs.push_back({"steel", "steel", spring(friction)});
  return scene;
}

/// One block pressed into the wall x = 0 by `depth`, its point there at the height of its centre.
struct Pressed {
  Scene scene;
  Assembly assembly;
  SceneState state;
  Island island{{0}, 0, 1};
  StageSolver solver;

  explicit Pressed(double depth, double speed = 0, double friction = 0,
                   const StageSolver::Settings& settings = {})
      : scene(blocks_at_wall(1, friction)), assembly(scene), solver(assembly, settings) {
    state.items.resize(1);
    state.items[0].position = {depth, 0, 0};
    state.items[0].velocity.chassis[0] = speed;
    BodyContactState contact;
    contact.contact.other = 1;
    contact.contact.normal = -Vector3::UnitX();
    contact.compression = depth;
    state.contacts = {contact};
  }
  StageSolver::Input input(const SceneState& start) const {
    StageSolver::Input input;
    input.start = &start;
    input.island = &island;
    input.tau = kTau;
    input.guess.resize(assembly.items.size());
    for (std::size_t i : island.items) input.guess[i] = start.items[i].velocity;
    return input;
  }
};

// Implicit Euler of m x'' = -k x: v (1 + tau^2 k / m) = v0 - tau k / m x0, x = x0 + tau v.
TEST(StageSolver, SolvesOneStageOfAMassOnASpring) {
  Pressed block(1e-3, 0.5);
  StageSolver::Output out;
  ASSERT_TRUE(block.solver.solve(block.input(block.state), out));
  const double v = (0.5 - kTau * kStiffness / kMass * 1e-3) / (1 + kShare);
  EXPECT_NEAR(out.end.items[0].velocity.chassis[0], v, 1e-12);
  EXPECT_NEAR(out.end.items[0].position.x(), 1e-3 + kTau * v, 1e-15);
  EXPECT_NEAR(out.end.contacts[0].compression, 1e-3 + kTau * v, 1e-15);
  EXPECT_NEAR(out.contacts[0].normal_force, kStiffness * (1e-3 + kTau * v), 1e-8);
  EXPECT_NEAR(out.contacts[0].normal_speed, -v, 1e-12);
  EXPECT_LE(out.iterations, 1);
  EXPECT_LT(out.residual, 1e-9);
}

// The method's stability function, (1 + (1 - 2 gamma) z) / (1 - gamma z)^2 with z = i phi: applied
// to x + i v / omega it is one step of the oscillator.
TEST(StageSolver, TwoStagesAreTheMethodOfSecondOrder) {
  constexpr double kStep = kTau / kSdirkGamma, kOff = (1 - kSdirkGamma) / kSdirkGamma;
  Pressed block(1e-3, 0.1);
  StageSolver::Output first, second;
  ASSERT_TRUE(block.solver.solve(block.input(block.state), first));
  SceneState between = block.state;
  between.items[0].position += kOff * (first.end.items[0].position - block.state.items[0].position);
  between.items[0].velocity.chassis[0] +=
      (1 - kSdirkGamma) * kStep * first.items[0].acceleration.chassis[0];
  ASSERT_TRUE(block.solver.solve(block.input(between), second));
  const double omega = std::sqrt(kStiffness / kMass);
  using Complex = std::complex<double>;
  const Complex z(0, -omega * kStep), from(1e-3, 0.1 / omega);
  const Complex to = (1.0 + (1 - 2 * kSdirkGamma) * z) / std::pow(1.0 - kSdirkGamma * z, 2) * from;
  EXPECT_NEAR(second.end.items[0].position.x(), to.real(), 1e-14);
  EXPECT_NEAR(second.end.items[0].velocity.chassis[0] / omega, to.imag(), 1e-13);
}

// Coulomb: a point that slides is slowed by mu N tau / m, whatever its speed, along its way.
TEST(StageSolver, LimitsFrictionToACone) {
  Pressed block(1e-3, 0, 0.3);
  block.state.items[0].velocity.chassis.segment<2>(1) << 3, 4;
  StageSolver::Output out;
  ASSERT_TRUE(block.solver.solve(block.input(block.state), out));
  const double normal = kStiffness * 1e-3 / (1 + kShare);
  EXPECT_NEAR(out.contacts[0].normal_force, normal, 1e-8);
  const double slower = 0.3 * normal * kTau / kMass;
  const Velocity& v = out.end.items[0].velocity;
  EXPECT_NEAR(v.chassis[1], 3 - 0.6 * slower, 1e-12);
  EXPECT_NEAR(v.chassis[2], 4 - 0.8 * slower, 1e-12);
  EXPECT_TRUE(out.end.contacts[0].sliding);
}

TEST(StageSolver, AContactThatIsApartAtTheEndCarriesNothing) {
  Pressed block(-1e-3, 0.1);
  StageSolver::Output out;
  ASSERT_TRUE(block.solver.solve(block.input(block.state), out));
  EXPECT_EQ(out.contacts[0].normal_force, 0);
  EXPECT_EQ(out.end.items[0].velocity.chassis[0], 0.1);
}

/// Blocks in a row along x, the first two pressed together by kDepth, the third kDepth away from
/// them.
constexpr double kDepth = 1e-3;

BodyContactState between(std::size_t item, double depth) {
  BodyContactState touch;
  touch.contact.side = {item, -1, {0.25 + std::max(depth, 0.0), 0, 0}, Vector3::Zero()};
  touch.contact.other = BodyContact::kItem;
  touch.contact.other_side = {item + 1, -1, {-0.25, 0, 0}, Vector3::Zero()};
  touch.contact.normal = -Vector3::UnitX();
  touch.compression = depth;
  return touch;
}

StageSolver::Output solved_row(std::size_t count) {
  const Scene scene = blocks_at_wall(count);
  const Assembly assembly(scene);
  SceneState state;
  state.items.resize(count);
  Island island;
  for (std::size_t i = 0; i < count; ++i) {
    island.items.push_back(i);
    state.items[i].position = {0.5 * static_cast<double>(i) + (i == 2 ? kDepth : 0), 0, 0};
    if (i > 0) state.contacts.push_back(between(i - 1, i == 1 ? kDepth : -kDepth));
  }
  island.end_contact = state.contacts.size();
  StageSolver::Input input;
  input.start = &state;
  input.island = &island;
  input.tau = kTau;
  input.guess.resize(count);
  StageSolver::Output out;
  StageSolver solver(assembly, {});
  EXPECT_TRUE(solver.solve(input, out));
  return out;
}

// Two blocks pressed together by d: the reduced mass on the spring, and as much for the one as for
// the other.
TEST(StageSolver, CouplesItemsThatTouch) {
  const StageSolver::Output out = solved_row(2);
  const double force = kStiffness * kDepth / (1 + 2 * kShare);
  EXPECT_NEAR(out.contacts[0].normal_force, force, 1e-8);
  EXPECT_NEAR(out.end.items[0].velocity.chassis[0], -force * kTau / kMass, 1e-13);
  EXPECT_NEAR(out.end.items[1].velocity.chassis[0], force * kTau / kMass, 1e-13);
  EXPECT_LE(out.iterations, 1);  // it knows how they push each other
  EXPECT_NEAR(out.items[1].power.work_of_neighbours, force * force * kTau / kMass, 1e-6);
}

TEST(StageSolver, ABlockThatMayBeTouchedAndIsNotIsSolvedApart) {
  const StageSolver::Output two = solved_row(2), three = solved_row(3);
  EXPECT_EQ(three.end.items[2].velocity.chassis, Vector6(Vector6::Zero()));
  EXPECT_EQ(three.contacts[1].normal_force, 0);
  for (std::size_t i : {0, 1})  // the same bits as of a system of two
    EXPECT_EQ(three.end.items[i].velocity.chassis, two.end.items[i].velocity.chassis);
}

TEST(StageSolver, SaysThatItDidNotConverge) {
  Pressed none(1e-3, 0, 0, {.max_iterations = 0});
  StageSolver::Output out;
  EXPECT_FALSE(none.solver.solve(none.input(none.state), out));
  EXPECT_GT(out.residual, 0.1);
  EXPECT_EQ(out.end.items[0].velocity.chassis[0], 0);  // the last iterate is its guess

  Pressed lost(1e-3, std::numeric_limits<double>::quiet_NaN());
  StageSolver::Output untouched;
  EXPECT_FALSE(lost.solver.solve(lost.input(lost.state), untouched));
  EXPECT_FALSE(std::isfinite(untouched.residual));
  EXPECT_TRUE(untouched.end.items.empty());
}

}  // namespace
}  // namespace gurney
