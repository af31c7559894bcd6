#include "engine/solver/equilibrium.h"

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/error.h"
#include "engine/solver/floor_points.h"
#include "engine/solver/stage_solver.h"

namespace gurney {

State placed_above(const Assembly& assembly, const Scene& scene, std::size_t item) {
  State state = assembly.items[item].placed(scene.items[item].initial);
  if (const auto& on = scene.items[item].on) state.position.z() += on->height;
  return state;
}

namespace {

constexpr double kPseudoStep = 0.02;  // [s]; long against every period of the treads
constexpr int kMaxPseudoSteps = 3000;
constexpr double kNearFloor = 0.02;    // [m]; points above do not stand on it
constexpr double kRestMotion = 1e-12;  // [m] in one pseudo step

/// Implicit Euler steps that start from rest each time: M / tau^2 regularises Newton's method on
/// the static problem, and the fixed point is an equilibrium.
bool relax(const Assembly& standing, double pseudo_step, SceneState& scene) {
  StageSolver solver(standing, {1e-10, 200});
  StageSolver::Output out;
  StageSolver::Input input;
  const Island alone{{0}, 0, scene.contacts.size()};
  const Mechanism& mechanism = standing.items.front();
  State& state = scene.items.front();
  input.tau = pseudo_step;
  input.island = &alone;
  input.guess.resize(1);
  for (int i = 0; i < kMaxPseudoSteps; ++i) {
    input.start = &scene;
    input.loads = {input.tau, state.time, state.time + input.tau, true, nullptr};
    if (!solver.solve(input, out) && !(out.residual < 1e-6)) return false;
    const Velocity& end = out.end.items.front().velocity;
    double motion = end.chassis.cwiseAbs().maxCoeff();
    for (std::size_t k = 0; k < mechanism.casters.size(); ++k)
      motion = std::max(motion, end.joints[k].cwiseAbs().maxCoeff());
    const double time = state.time;
    scene = out.end;
    state.time = time;
    state.velocity = Velocity();
    if (!(motion < 1e3)) return false;
    if (motion * pseudo_step < kRestMotion) return true;
  }
  return false;
}

/// The item's contact with the floor has the constants of what it stands on, no damping here, and
/// `friction` or its own.
void stand_on_springs(Scene& scene, const std::string& below, std::optional<double> friction) {
  const std::string& material = scene.items[0].model.material;
  ContactConstants constants = contact_constants(scene, material, below);
  constants.kind = ContactConstants::Kind::kCompliant;
  constants.damping = 0;
  constants.friction = friction.value_or(constants.friction);
  scene.pairs.insert(scene.pairs.begin(), {material, scene.floor_material, constants});
}

void stop_at_zero_rate(Fixture& fixture) {
  for (Guide& guide : fixture.guides)
    if (guide.kind == Guide::Kind::kVelocity) guide = {Guide::Kind::kHeld, 0, 0, 0};
}

/// The item alone on the bare floor, its guides at rest.
Scene alone(const Scene& scene, std::size_t item) {
  Scene one = scene;
  one.items = {scene.items[item]};
  one.items[0].on.reset();
  stop_at_zero_rate(one.items[0].fixture);
  one.room.clear();
  one.tethers.clear();
  return one;
}

/// Whether an item stands on another, or on what stands on that.
bool is_carried_by(const Scene& scene, std::size_t item, std::size_t below) {
  const std::optional<Support>& on = scene.items[item].on;
  if (!on || on->kind != Support::Kind::kItem) return false;
  return on->index == below || is_carried_by(scene, on->index, below);
}

/// Weights of what stands on the item, at the centres of mass.
void add_carried_weights(const Assembly& assembly, const Scene& scene, std::size_t item,
                         std::vector<Load>& loads) {
  const State below = placed_above(assembly, scene, item);
  const Vector3& center = assembly.items[item].chassis.center_of_mass;
  for (std::size_t i = item + 1; i < scene.items.size(); ++i) {
    if (!is_carried_by(scene, i, item)) continue;
    const double weight = -assembly.items[i].total_mass * assembly.items[i].gravity.z();
    const Vector3 there = placed_above(assembly, scene, i).position - below.position;
    PointForce force;
    force.name = "weight of item " + std::to_string(i);
    force.point = center + below.rotation.conjugate() * there;
    force.direction = -Vector3::UnitZ();
    force.time = {0, 2 * kPseudoStep};
    force.force = {weight, weight};
    loads.push_back(std::move(force));
  }
}

/// Raises an item that has settled as on the floor to the surface that it stands on, with what that
/// has settled by.
/// @param settled  its contacts with the floor, which become those with that surface
void raise(const Assembly& assembly, const Scene& scene, std::size_t item,
           const std::vector<BodyContactState>& settled, SceneState& all) {
  const Support& on = *scene.items[item].on;
  State& state = all.items[item];
  state.position.z() += on.height;
  const bool on_item = on.kind == Support::Kind::kItem;
  if (on_item) {
    const State from = placed_above(assembly, scene, on.index);
    const State& to = all.items[on.index];
    const Quaternion turn = to.rotation * from.rotation.conjugate();
    state.position = to.position + turn * (state.position - from.position);
    state.rotation = turn * state.rotation;
  }
  for (BodyContactState memory : settled) {
    BodyContact& contact = memory.contact;
    contact.side.item = item;
    contact.other = static_cast<int>(on.index) + 1;
    if (on_item) {
      const State& below = all.items[on.index];
      const Vector3 point = state.position + state.rotation * contact.side.local;
      contact.other = BodyContact::kItem;
      contact.other_side = contact.side;
      contact.side = {on.index, -1, below.rotation.conjugate() * (point - below.position)};
    }
    all.contacts.push_back(memory);
  }
}

}  // namespace

void settle(const Assembly& assembly, const Scene& scene, std::size_t index, SceneState& all) {
  const Mechanism& mechanism = assembly.items[index];
  State& state = all.items[index];
  Scene level = alone(scene, index);
  level.slope = level.cross_slope = 0;
  level.gravity = -mechanism.gravity.z();
  PlacedItem& held = level.items[0];
  held.loads.clear();
  add_carried_weights(assembly, scene, index, held.loads);
  for (int dof : {0, 1, 5}) held.fixture.guides[dof] = {Guide::Kind::kHeld, 0, 0, 0};
  // Nothing pushes sideways: without friction the treads settle without holding each other.
  for (Caster& caster : held.model.casters) {
    caster.tread.static_friction = caster.tread.kinetic_friction = 0;
    caster.tread.rolling_friction_length = 0;
    caster.brake_torque = caster.swivel_lock_torque = std::numeric_limits<double>::infinity();
  }
  const std::string below = material_below(scene, index);
  stand_on_springs(level, below, 0);
  const Assembly standing(level);
  SceneState settled{{state}, {}};
  settled.items[0].loads = standing.items[0].loads.initial_state();
  std::vector<BodyContact> contacts;
  FloorPoints(scene.items[index].model, mechanism, 0).collect(state, {}, kNearFloor, contacts);
  for (const BodyContact& contact : contacts) settled.contacts.emplace_back().contact = contact;
  const bool stands = relax(standing, kPseudoStep, settled);
  const State& there = settled.items[0];
  const double tilt = std::acos(std::min(1.0, (there.rotation * Vector3::UnitZ()).z()));
  const bool on_casters = !scene.items[index].model.casters.empty();
  require(stands && tilt < 0.2 && std::abs(there.position.z() - state.position.z()) < 0.1,
          on_casters ? "the item does not stand on its casters: its centre of mass lies outside "
                       "their support"
                     : "the item does not stand on its base: its centre of mass lies outside it");
  LoadsState loads = state.loads;
  mechanism.loads.adopt_springs(standing.items[0].loads, there.loads, loads);
  const auto adopt = [&](const SceneState& found) {
    state = found.items[0];
    state.loads = loads;
    std::erase_if(all.contacts,
                  [&](const BodyContactState& c) { return c.contact.side.item == index; });
    for (BodyContactState memory : found.contacts) {
      memory.contact.side.item = index;
      all.contacts.push_back(memory);
    }
  };
  if (scene.items[index].on) {
    state = there;
    state.loads = loads;
    return raise(assembly, scene, index, settled.contacts, all);
  }
  adopt(settled);
  const bool is_level = scene.slope == 0 && scene.cross_slope == 0;
  if (is_level && !mechanism.loads.holds_at_start()) return;

  Scene sprung = alone(scene, index);
  if (!mechanism.loads.holds_at_start()) sprung.items[0].loads.clear();
  stand_on_springs(sprung, below, std::nullopt);
  const Assembly free(sprung);
  SceneState trial = settled;
  trial.items[0].loads = free.items[0].loads.initial_state();
  if (!relax(free, kPseudoStep, trial)) return;
  mechanism.loads.adopt_springs(free.items[0].loads, trial.items[0].loads, loads);
  if (mechanism.loads.holds_at_start()) loads = trial.items[0].loads;
  adopt(trial);
}

}  // namespace gurney
