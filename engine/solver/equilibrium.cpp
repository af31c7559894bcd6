#include "engine/solver/equilibrium.h"

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "engine/base/error.h"
#include "engine/solver/floor_points.h"
#include "engine/solver/stage_solver.h"

namespace gurney {
namespace {

constexpr double kPseudoStep = 0.02;  // [s]; long against every period of the treads
constexpr int kMaxPseudoSteps = 3000;
constexpr double kNearFloor = 0.02;    // [m]; points above do not stand on it
constexpr double kRestMotion = 1e-12;  // [m] in one pseudo step

/// Implicit Euler steps that start from rest each time: M / tau^2 regularises Newton's method on
/// the static problem, and the fixed point is an equilibrium.
bool relax(const Mechanism& mechanism, const std::vector<BodyContact>& contacts, double pseudo_step,
           State& state) {
  StageSolver solver(mechanism, {1e-10, 200});
  StageSolver::Output out;
  StageSolver::Input input;
  input.tau = pseudo_step;
  input.contacts = &contacts;
  state.contacts.resize(contacts.size());
  for (int i = 0; i < kMaxPseudoSteps; ++i) {
    input.start = &state;
    input.loads = {input.tau, state.time, state.time + input.tau, true, &state.loads};
    if (!solver.solve(input, out) && !(out.residual < 1e-6)) return false;
    double motion = out.end.velocity.chassis.cwiseAbs().maxCoeff();
    for (std::size_t k = 0; k < mechanism.legs.size(); ++k)
      motion = std::max(motion, out.end.velocity.joints[k].cwiseAbs().maxCoeff());
    const double time = state.time;
    state = out.end;
    state.time = time;
    state.velocity = Velocity();
    if (!(motion < 1e3)) return false;
    if (motion * pseudo_step < kRestMotion) return true;
  }
  return false;
}

/// The item's contact with the floor has no damping here, and `friction` or its own.
void stand_on_springs(Scene& scene, std::optional<double> friction) {
  ContactConstants constants = contact_constants(scene, scene.floor_material);
  constants.kind = ContactConstants::Kind::kCompliant;
  constants.damping = 0;
  constants.friction = friction.value_or(constants.friction);
  scene.pairs.insert(scene.pairs.begin(), {scene.item.material, scene.floor_material, constants});
}

void stop_at_zero_rate(Fixture& fixture) {
  for (Guide& guide : fixture.guides)
    if (guide.kind == Guide::Kind::kVelocity) guide = {Guide::Kind::kHeld, 0, 0, 0};
}

}  // namespace

void settle(const Mechanism& mechanism, const Scene& scene, const Excitation& excitation,
            State& state) {
  Excitation still;
  still.fixture = excitation.fixture;
  stop_at_zero_rate(still.fixture);
  Excitation held = still;
  for (int dof : {0, 1, 5}) held.fixture.guides[dof] = {Guide::Kind::kHeld, 0, 0, 0};
  Scene level = scene;
  level.slope = 0;
  level.gravity = scene.gravity * std::cos(std::atan(scene.slope));
  // Nothing pushes sideways: without friction the treads settle without holding each other.
  for (Caster& caster : level.item.casters) {
    caster.tread.static_friction = caster.tread.kinetic_friction = 0;
    caster.tread.rolling_resistance = 0;
    caster.brake_torque = caster.swivel_lock_torque = std::numeric_limits<double>::infinity();
  }
  stand_on_springs(level, 0);
  const Mechanism standing(level, held);
  State settled = state;
  settled.loads = standing.loads.initial_state();
  std::vector<BodyContact> contacts;
  FloorPoints(scene, mechanism).collect(state, kNearFloor, contacts);
  const bool stands = relax(standing, contacts, kPseudoStep, settled);
  const double tilt = std::acos(std::min(1.0, (settled.rotation * Vector3::UnitZ()).z()));
  require(stands && tilt < 0.2 && std::abs(settled.position.z() - state.position.z()) < 0.1,
          scene.item.casters.empty()
              ? "the item does not stand on its base: its centre of mass lies outside it"
              : "the item does not stand on its casters: its centre of mass lies outside their "
                "support");
  std::vector<double> loads = state.loads;
  mechanism.loads.adopt_springs(standing.loads, settled.loads, loads);
  state = settled;
  state.loads = loads;
  if (scene.slope == 0 && !mechanism.loads.holds_at_start()) return;

  Excitation loaded = excitation;
  stop_at_zero_rate(loaded.fixture);
  if (!mechanism.loads.holds_at_start()) {
    loaded.forces.clear();
    loaded.string_potentiometers.clear();
    loaded.drop_weights.clear();
  }
  Scene sprung = scene;
  stand_on_springs(sprung, std::nullopt);
  const Mechanism free(sprung, loaded);
  State trial = state;
  trial.loads = free.loads.initial_state();
  if (!relax(free, contacts, kPseudoStep, trial)) return;
  mechanism.loads.adopt_springs(free.loads, trial.loads, loads);
  state = trial;
  if (!mechanism.loads.holds_at_start()) state.loads = loads;
}

}  // namespace gurney
