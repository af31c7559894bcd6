#include "engine/solver/loads.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/base/units.h"

namespace gurney {
namespace {

constexpr double kGravity = kStandardGravity;
const Vector3 kCenter(0, 0, 0.5);

PlacedItem everything() {
  PlacedItem item;
  item.loads = {PointForce{"pull", {0.5, 0.1, 0.3}, {2, 0, 0}, {0, 1, 3}, {0, 40, 10}},
                StringPotentiometer{{-0.5, 0, 0.4}, {-1, 0, 0}, 7},
                DropWeight{.point = {0.5, 0, 0.3},
                           .direction = {1, 0, 0.2},
                           .mass = 5,
                           .drop_height = 0.4,
                           .pulley_inertia = 0.001,
                           .pulley_radius = 0.04,
                           .potentiometer_tension = 3},
                Blocks{{0.4, 0.2, 0}, 1e6, 1e3, 2.0}};
  item.fixture.guides[1] = {Guide::Kind::kSpring, 0, 500, 20};
  return item;
}

struct Evaluation {
  Loads loads{everything(), kCenter, kGravity};
  LoadsState state = loads.initial_state();
  LoadsState::Weight& weight() { return state.weights[0]; }
  Pose pose;
  Vector6 velocity = Vector6::Zero();

  Loads::Stage stage(bool first = true, double from = 1.0, double to = 1.01) const {
    return {0.003, from, to, first, &state};
  }
  std::vector<Loads::Row> rows(const Loads::Stage& at) const {
    std::vector<Loads::Row> result;
    loads.evaluate(at, pose, velocity, result);
    return result;
  }
};

TEST(Loads, RowsHoldForceAndMomentAboutTheChassis) {
  Evaluation e;
  e.pose.rotation = Eigen::AngleAxisd(0.5, Vector3::UnitZ()).toRotationMatrix();
  const auto rows = e.rows(e.stage());
  ASSERT_EQ(rows.size(), 6u);  // force, string, weight, two of the block, spring
  const Vector3 arm = e.pose.rotation * (Vector3(0.5, 0.1, 0.3) - kCenter);
  EXPECT_NEAR((rows[0].direction.head<3>() - Vector3::UnitX()).norm(), 0, 1e-15) << "unit vector";
  EXPECT_NEAR((rows[0].direction.tail<3>() - arm.cross(Vector3::UnitX())).norm(), 0, 1e-15);
  EXPECT_EQ(rows[1].force, 7);
  EXPECT_EQ(rows[5].direction, Vector6(Vector6::Unit(1)));
}

TEST(Loads, ATabulatedForceMeetsItsMeanOverTheStep) {
  // From 0.9 to 1.2 s the table has a corner: mean of (36 + 40) / 2 over 0.1 s and (40 + 37) / 2
  // over 0.2 s.
  Evaluation e;
  const double first = e.rows(e.stage(true, 0.9, 1.2))[0].force;
  const double second = e.rows(e.stage(false, 0.9, 1.2))[0].force;
  const double gamma = 1 - std::sqrt(0.5);
  EXPECT_NEAR((1 - gamma) * first + gamma * second, (38 * 0.1 + 38.5 * 0.2) / 0.3, 1e-12);
  EXPECT_EQ(e.rows(e.stage(true, 3.1, 3.2))[0].force, 0) << "zero after the table";
  EXPECT_DOUBLE_EQ(e.loads.pull_force(2, e.pose, e.velocity), 25);
  EXPECT_EQ(e.loads.pull_force(3.5, e.pose, e.velocity), 0);
}

TEST(Loads, SlopesAreThoseOfTheForces) {
  // Piecewise linear in velocity: central differences are exact but for rounding,
  // 1e3 N * 1e-16 / 1e-6.
  Evaluation e;
  e.weight().speed = 0.3;  // the weight falls
  for (double x : {-0.5, 0.0, 0.2}) {
    e.velocity << x, 0.1, 0, 0.2, -0.1, 0.3;
    const auto rows = e.rows(e.stage());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double step = 1e-6;
      const Vector6 direction = rows[i].direction / rows[i].direction.squaredNorm();
      Evaluation up = e, down = e;
      up.velocity += step * direction;
      down.velocity -= step * direction;
      const double slope =
          -(up.rows(up.stage())[i].force - down.rows(down.stage())[i].force) / (2 * step);
      EXPECT_NEAR(rows[i].slope, slope, 1e-9 * std::max(1.0, rows[i].slope) + 1e-6) << "row " << i;
    }
  }
}

TEST(Loads, APushFadesAtItsSpeedLimit) {
  // Of 40 N all up to 0.95 of the limit of 0.8 m/s, half in the middle, none beyond; the slope is
  // that of the line between.
  PlacedItem push;
  push.loads = {PointForce{"push", kCenter, {1, 0, 0}, {0, 3}, {40, 40}, 0.8}};
  const Loads loads(push, kCenter, kGravity);
  const LoadsState state = loads.initial_state();
  const auto at = [&](double speed) {
    std::vector<Loads::Row> rows;
    loads.evaluate({0.003, 1, 1.01, true, &state}, {}, speed * Vector6::Unit(0), rows);
    EXPECT_NEAR(loads.pull_force(1, {}, speed * Vector6::Unit(0)), rows.at(0).force, 1e-9);
    return rows.at(0);
  };
  for (const double below : {-5.0, 0.0, 0.759}) {
    EXPECT_NEAR(at(below).force, 40, 1e-9) << below;
    EXPECT_EQ(at(below).slope, 0) << below;
  }
  EXPECT_NEAR(at(0.78).force, 20, 1e-9);
  EXPECT_NEAR(at(0.78).slope, 40 / (0.05 * 0.8), 1e-9);
  EXPECT_EQ(at(0.801).force, 0);
  EXPECT_EQ(at(0.801).slope, 0);
}

TEST(Loads, AHangingWeightStretchesItsCableWhileBlocksHold) {
  Evaluation e;
  const double tension = 5 * kGravity - 3;
  EXPECT_NEAR(e.loads.cable_tension(e.state), tension, 1e-9);
  EXPECT_NEAR(e.rows(e.stage())[2].force, tension, 1e-9) << "nothing moves";
  EXPECT_NEAR(e.loads.stored_energy(e.state), tension * tension / 2e6, 1e-12);
}

TEST(Loads, TheWeightObeysItsOwnEquation) {
  // (m + I_p / r_p^2) w' = m g - T_pot - T over the stage, with the cable's own tension.
  Evaluation e;
  e.weight().speed = 0.3;
  e.velocity[0] = 0.25;
  const double tension = e.rows(e.stage())[2].force;
  EnergyAccount power;
  LoadsState end;
  e.loads.finish(e.stage(), e.pose, e.velocity, e.rows(e.stage()), power, end);
  const LoadsState::Weight& after = end.weights[0];
  const double inertia = 5 + 0.001 / 0.0016;
  EXPECT_NEAR(inertia * (after.speed - 0.3) / 0.003, 5 * kGravity - 3 - tension, 1e-9);
  EXPECT_NEAR(after.fall, 0.003 * after.speed, 1e-15);
  const Vector3 direction = Vector3(1, 0, 0.2).normalized();
  const double stretch_rate = after.speed - direction.x() * 0.25;
  EXPECT_NEAR(tension, 1e6 * after.stretch + 500 * stretch_rate, 1e-9);
}

TEST(Loads, ASlackCableCarriesNothing) {
  Evaluation e;
  e.velocity[0] = 5;  // the chassis runs away from the weight's side
  const auto rows = e.rows(e.stage());
  EXPECT_EQ(rows[2].force, 0);
  EXPECT_EQ(rows[2].slope, 0);
}

TEST(Loads, AWeightLandsAtItsDropHeight) {
  Evaluation e;
  EXPECT_NEAR(e.loads.penetration(e.state), -0.4, 1e-15);
  e.weight().fall = 0.4;
  e.weight().speed = 1.5;
  const double inertia = 5 + 0.001 / 0.0016;
  e.weight().stretch = 1e-4;
  const double in_cable = 0.5 * DropWeight().cable_stiffness * 1e-8;
  EXPECT_NEAR(e.loads.land(e.state), 0.5 * inertia * 1.5 * 1.5 + in_cable, 1e-12);
  EXPECT_EQ(e.weight().speed, 0);
  EXPECT_EQ(e.weight().stretch, 0) << "slack";
  EXPECT_TRUE(e.weight().landed);
  EXPECT_EQ(e.loads.penetration(e.state), -1) << "none falls any more";
  EXPECT_EQ(e.loads.land(e.state), 0) << "once";
  e.velocity[0] = 1;
  EnergyAccount power;
  LoadsState end;
  e.loads.finish(e.stage(), e.pose, e.velocity, e.rows(e.stage()), power, end);
  EXPECT_EQ(end.weights[0].speed, 0) << "it rests";
}

TEST(Loads, ASlackCableStaysSlackWhenItsWeightLands) {
  Evaluation e;
  e.weight().fall = 0.4;
  e.weight().stretch = -0.02;
  e.loads.land(e.state);
  EXPECT_EQ(e.weight().stretch, -0.02);
}

TEST(Loads, BlocksLetGoAtTheirTime) {
  Evaluation e;
  e.velocity << 0.1, -0.2, 0, 0, 0, 0;
  const double slope = 1e6 * 0.003 + 1e3;
  EXPECT_NEAR(e.rows(e.stage())[3].force, -slope * 0.1, 1e-9);
  EXPECT_NEAR(e.rows(e.stage())[4].force, slope * 0.2, 1e-9);
  EXPECT_EQ(e.rows(e.stage(true, 2.0, 2.01)).size(), 4u);
  e.state.blocks[0].x() = 1e-4;
  EXPECT_EQ(e.loads.release(1.9, e.state), 0);
  EXPECT_NEAR(e.loads.release(2.0, e.state), 0.5 * 1e6 * 1e-8, 1e-15);
  EXPECT_EQ(e.state.blocks[0].x(), 0);
}

TEST(Loads, BreakpointsAreWhereLoadsChange) {
  EXPECT_EQ(Evaluation().loads.breakpoints(), (std::vector<double>{0, 1, 3, 2}));
}

}  // namespace
}  // namespace gurney
