#include <fmt/core.h>
#include <gtest/gtest.h>

#include <limits>

#include "tests/benchmark/workload.h"
#include "tests/peers/our_path.h"

// The shipped trolley under three-component motions on MuJoCo, ODE and ours: docs/theory/peers.md.
namespace gurney::peers {
namespace {

constexpr double kStep = 5e-4;  // of the peers [s]
constexpr double kOurStep = 2e-4;

/// Treads that act as rigid: the path moves by another 0.4 mm up to 3e9 N/m.
CrossCheck free_casters(unsigned record, bool resistance) {
  CrossCheck check = trolley_check(record, 0.4);
  benchmark::make_rigid(check.scene, 3e8, 1e8);
  if (!resistance)
    for (Caster& caster : check.scene.items[0].model.casters)
      caster.tread.rolling_friction_length = 0;
  return check;
}

/// A sliding block: forks and wheels locked, friction 0.2.
CrossCheck locked_casters(unsigned record) {
  CrossCheck check = free_casters(record, true);
  for (Caster& caster : check.scene.items[0].model.casters) {
    caster.swivels = false;
    caster.brake_torque = std::numeric_limits<double>::infinity();
    caster.tread.static_friction = caster.tread.kinetic_friction = 0.2;
  }
  check.floor = benchmark::shaking(record, 0.6);
  return check;
}

struct Peer {
  const char* name;
  Path (*path_of)(const CrossCheck&, double, Setup);
};
constexpr Peer kPeers[] = {{"MuJoCo", mujoco_path}, {"ODE", ode_path}};

Path our_path(const CrossCheck& check) { return our_path(check, kOurStep); }

/// Prints a row of the table of docs/theory/peers.md.
void row(const char* what, unsigned record, const char* engine, double step, const Path& ours,
         const Path& theirs) {
  fmt::print("| {} | {} | {} | {:g} | {:.2f} | {:.2f} | {:.2f} |\n", what, record, engine,
             1e3 * step, 1e3 * peak(ours), 1e3 * peak(theirs), 1e3 * distance(ours, theirs));
}

// Without losses nothing is left to differ but time steps: 0.1 % of the peak. Both peers are of
// first order, so a quarter of the step leaves a quarter of the distance.
TEST(Peers, WithoutRollingResistanceAllTakeOnePath) {
  constexpr unsigned kRecord = 2;
  const CrossCheck check = free_casters(kRecord, false);
  const Path ours = our_path(check);
  for (const auto& [name, path_of] : kPeers) {
    SCOPED_TRACE(fmt::format("{}, record {}", name, kRecord));
    const Path coarse = path_of(check, 4 * kStep, Setup::kBest),
               fine = path_of(check, kStep, Setup::kBest);
    row("no resistance", kRecord, name, 4 * kStep, ours, coarse);
    row("no resistance", kRecord, name, kStep, ours, fine);
    EXPECT_LT(distance(ours, fine), 0.001 * peak(ours));
    EXPECT_LT(distance(ours, fine), 0.4 * distance(ours, coarse));
  }
}

// Theirs is friction of the axle with the load of the step before, ours a couple between wheel and
// floor with its own: 0.5 % of the peak.
TEST(Peers, WithRollingResistanceAllTakeOnePath) {
  for (const unsigned record : {1u, 2u}) {
    const CrossCheck check = free_casters(record, true);
    const Path ours = our_path(check);
    for (const auto& [name, path_of] : kPeers) {
      SCOPED_TRACE(fmt::format("{}, record {}", name, record));
      const Path theirs = path_of(check, kStep, Setup::kBest);
      row("resistance", record, name, kStep, ours, theirs);
      EXPECT_LT(distance(ours, theirs), 0.005 * peak(ours));
      EXPECT_NEAR(peak(theirs), peak(ours), 0.005 * peak(ours));
    }
  }
}

TEST(Peers, LockedWheelsSlideInACone) {
  constexpr unsigned kRecord = 1;
  const CrossCheck check = locked_casters(kRecord);
  const Path ours = our_path(check), mujoco = mujoco_path(check, kStep, Setup::kBest),
             ode = ode_path(check, kStep, Setup::kBest),
             pyramid = ode_path(check, kStep, Setup::kStiff);
  row("locked", kRecord, "MuJoCo", kStep, ours, mujoco);
  row("locked", kRecord, "ODE", kStep, ours, ode);
  row("locked", kRecord, "ODE, pyramids", kStep, ours, pyramid);
  for (const Path& theirs : {mujoco, ode}) {
    EXPECT_NEAR(peak(theirs), peak(ours), 0.05 * peak(ours));
    EXPECT_LT(distance(ours, theirs), 0.05 * peak(ours));
  }
  // The pyramid holds up to sqrt(2) times as much between its axes: it slides less.
  EXPECT_LT(peak(pyramid), 0.95 * peak(ours));
}

// Along one of its axes the pyramid is a cone.
TEST(Peers, LockedWheelsSlideAlikeAlongTheAxesOfThePyramid) {
  const CrossCheck check = along_x(locked_casters(1));
  const Path ours = our_path(check), cone = mujoco_path(check, kStep, Setup::kBest),
             pyramid = ode_path(check, kStep, Setup::kStiff);
  row("locked, x", 1, "MuJoCo", kStep, ours, cone);
  row("locked, x", 1, "ODE, pyramids", kStep, ours, pyramid);
  EXPECT_LT(distance(ours, pyramid), 0.03 * peak(ours));
  EXPECT_LT(distance(ours, cone), 0.03 * peak(ours));
}

}  // namespace
}  // namespace gurney::peers
