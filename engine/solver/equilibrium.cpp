#include "engine/solver/equilibrium.h"

#include <fmt/format.h>

#include <algorithm>
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
  if (const auto& on = scene.items[assembly.roots[item]].on) state.position.z() += on->height;
  return state;
}

namespace {

constexpr double kPseudoStep = 0.02;  // [s]; long against every period of the treads
constexpr int kMaxPseudoSteps = 3000;
constexpr double kNearFloor = 0.02;    // [m]; points above do not stand on it
constexpr double kRestMotion = 1e-12;  // [m] in one pseudo step
constexpr double kPush = 1e-3;         // [rad] in the first pseudo step
constexpr double kStablePush = 3e-3;  // [rad]; what is stable comes back, what is indifferent stays
constexpr double kPushStep = 0.05;    // [s]
constexpr int kPushSteps = 400;

/// Implicit Euler steps that start from rest each time: M / tau^2 regularises Newton's method on
/// the static problem, and the fixed point is an equilibrium.
/// @param stop  ends them, asked after each
template <class Stop>
bool relax(const Assembly& standing, double pseudo_step, int most, SceneState& scene,
           const Stop& stop) {
  StageSolver solver(standing, {1e-10, 200});
  StageSolver::Output out;
  StageSolver::Input input;
  Island all{{}, 0, scene.contacts.size()};
  for (std::size_t i = 0; i < standing.items.size(); ++i) all.items.push_back(i);
  for (std::size_t j = 0; j < standing.joints.size(); ++j) all.joints.push_back(j);
  const double time = scene.items.front().time;
  input.tau = pseudo_step;
  input.island = &all;
  input.loads = {input.tau, time, time + input.tau, true, nullptr};
  input.guess.resize(standing.items.size());
  for (int i = 0; i < most; ++i) {
    input.start = &scene;
    if (!solver.solve(input, out) && !(out.residual < 1e-6)) return false;
    scene = out.end;
    double motion = 0;
    for (std::size_t k = 0; k < scene.items.size(); ++k) {
      State& state = scene.items[k];
      motion = std::max(motion, state.velocity.chassis.cwiseAbs().maxCoeff());
      for (std::size_t c = 0; c < standing.items[k].casters.size(); ++c)
        motion = std::max(motion, state.velocity.joints[c].cwiseAbs().maxCoeff());
      state.time = time;
      state.velocity = Velocity();
    }
    if (!(motion < 1e3)) return false;
    if (motion * pseudo_step < kRestMotion || stop()) return true;
  }
  return false;
}

/// Likewise, with what follows where a latch would bear more than it holds: it is open.
bool come_to_rest(const Assembly& standing, SceneState& scene) {
  for (;;) {
    const bool rests = relax(standing, kPseudoStep, kMaxPseudoSteps, scene, [] { return false; });
    bool opened = false;
    for (std::size_t j = 0; j < standing.joints.size(); ++j) {
      JointState& joint = scene.joints[j];
      if (standing.joints[j].past_release(joint) < -JointLaw::kReleaseDistance) continue;
      joint.latched = false;
      opened = true;
    }
    if (!opened) return rests;
  }
}

/// How far the joint has turned once it and all that hangs on it were pushed by `angle` about `about`.
double turned_by_push(const Assembly& standing, const SceneState& rest, std::size_t j,
                      const Vector3& about, double angle) {
  const Joint& joint = standing.joints[j].joint();
  SceneState pushed = rest;
  const State& part = rest.items[joint.part];
  const Vector3 spin = angle / kPushStep * (part.rotation * about);
  const auto place_in = [](const State& body, const Vector3& local) -> Vector3 {
    return body.position + body.rotation * local;
  };
  const Vector3 point =
      place_in(part, joint.point - standing.items[joint.part].chassis.center_of_mass);
  std::vector<bool> moves(rest.items.size(), false);
  moves[joint.part] = true;
  for (const JointLaw& each : standing.joints)  // bases come before their parts
    if (moves[each.joint().base]) moves[each.joint().part] = true;
  for (std::size_t i = 0; i < moves.size(); ++i)
    if (moves[i])
      pushed.items[i].velocity.chassis << spin.cross(rest.items[i].position - point), spin;
  const auto bend = [&](const SceneState& scene) {
    return scene.items[joint.base].rotation.conjugate() * scene.items[joint.part].rotation;
  };
  double turned = 0;
  relax(standing, kPushStep, kPushSteps, pushed, [&] {
    turned = bend(rest).angularDistance(bend(pushed));
    return turned > kStablePush || turned < kPush / 2;
  });
  return turned;
}

/// The joint of a part that leaves its rest by itself once it is pushed to either side, as a mast does that is
/// too soft for what it carries and stands exactly upright. An angle that grows as exp(w t) grows by w^2 tau^2
/// in a pseudo step tau, one that swings falls so: 400 of 0.05 s tell w > 1.1 rad/s. A damper that lets it
/// fall more slowly hides it.
std::optional<std::size_t> unstable_joint(const Assembly& standing, const SceneState& rest) {
  for (std::size_t j = 0; j < standing.joints.size(); ++j) {
    const Joint& joint = standing.joints[j].joint();
    if (joint.kind == Joint::Kind::kFixed || joint.kind == Joint::Kind::kSlider ||
        rest.joints[j].latched)
      continue;
    const Vector3 across = joint.axis.unitOrthogonal();
    Vector3 about = joint.axis;
    if (joint.kind != Joint::Kind::kHinge)  // in no direction of symmetry
      about = (across + 0.7 * joint.axis.cross(across)).normalized();
    for (const double angle : {kPush, -kPush})
      if (turned_by_push(standing, rest, j, about, angle) > kStablePush) return j;
  }
  return {};
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

/// An item and its parts, in their order.
std::vector<std::size_t> bodies_of(const Assembly& assembly, std::size_t item) {
  std::vector<std::size_t> bodies;
  for (std::size_t i = item; i < assembly.items.size(); ++i)
    if (assembly.roots[i] == item) bodies.push_back(i);
  return bodies;
}

/// The item with its parts alone on the bare floor, its guides at rest.
Scene alone(const Scene& scene, const std::vector<std::size_t>& bodies) {
  Scene one = scene;
  one.items.clear();
  one.joints.clear();
  for (std::size_t body : bodies) {
    if (const auto joint = joint_of(scene, body)) {
      const auto place_of = [&](std::size_t item) {
        return static_cast<std::size_t>(std::ranges::find(bodies, item) - bodies.begin());
      };
      Joint& added = one.joints.emplace_back(scene.joints[*joint]);
      added.base = place_of(added.base);
      added.part = place_of(added.part);
    }
    one.items.push_back(scene.items[body]);
  }
  one.items[0].on.reset();
  stop_at_zero_rate(one.items[0].fixture);
  one.room.clear();
  one.tethers.clear();
  return one;
}

/// The body of the mechanism `root` that carries an item which stands on it, over others that do.
std::optional<std::size_t> carrier_of(const Assembly& assembly, const Scene& scene,
                                      std::size_t item, std::size_t root) {
  while (assembly.roots[item] != root) {
    const std::optional<Support>& on = scene.items[item].on;
    if (const auto joint = joint_of(scene, item))
      item = scene.joints[*joint].base;
    else if (on && on->kind == Support::Kind::kItem)
      item = on->index;
    else
      return {};
  }
  return item;
}

/// Weights of what stands on the body, at the centres of mass.
void add_carried_weights(const Assembly& assembly, const Scene& scene, std::size_t item,
                         std::vector<Load>& loads) {
  const State below = placed_above(assembly, scene, item);
  const Vector3& center = assembly.items[item].chassis.center_of_mass;
  for (std::size_t i = item + 1; i < scene.items.size(); ++i) {
    if (assembly.joined(i, item)) continue;
    if (carrier_of(assembly, scene, i, assembly.roots[item]) != item) continue;
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

/// Raises an item that has settled as on the floor, with its parts, to the surface that it stands on,
/// with what that has settled by.
/// @param settled  its contacts with the floor, which become those with that surface
void raise(const Assembly& assembly, const Scene& scene, std::size_t item,
           const std::vector<BodyContactState>& settled, SceneState& all) {
  const Support& on = *scene.items[item].on;
  const bool on_item = on.kind == Support::Kind::kItem;
  for (std::size_t body : bodies_of(assembly, item)) {
    State& state = all.items[body];
    state.position.z() += on.height;
    if (!on_item) continue;
    const State from = placed_above(assembly, scene, on.index);
    const State& to = all.items[on.index];
    const Quaternion turn = to.rotation * from.rotation.conjugate();
    state.position = to.position + turn * (state.position - from.position);
    state.rotation = turn * state.rotation;
  }
  const State& state = all.items[item];
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
  const std::vector<std::size_t> bodies = bodies_of(assembly, index);
  Scene level = alone(scene, bodies);
  level.slope = level.cross_slope = 0;
  level.gravity = -mechanism.gravity.z();
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    level.items[k].loads.clear();
    add_carried_weights(assembly, scene, bodies[k], level.items[k].loads);
  }
  PlacedItem& held = level.items[0];
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
  SceneState settled;
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    settled.items.push_back(all.items[bodies[k]]);
    settled.items[k].loads = standing.items[k].loads.initial_state();
  }
  for (const JointLaw& joint : standing.joints) settled.joints.push_back(joint.initial_state());
  std::vector<BodyContact> contacts;
  FloorPoints(scene.items[index].model, mechanism, 0).collect(state, {}, kNearFloor, contacts);
  for (const BodyContact& contact : contacts) settled.contacts.emplace_back().contact = contact;
  const bool stands = come_to_rest(standing, settled);
  const State& there = settled.items[0];
  const double tilt = std::acos(std::min(1.0, (there.rotation * Vector3::UnitZ()).z()));
  const bool on_casters = !scene.items[index].model.casters.empty();
  const bool rests = tilt < 0.2 && std::abs(there.position.z() - state.position.z()) < 0.1;
  const auto refuse = [&](const std::string& why) {
    const std::string& name = scene.items[index].name;
    throw Error((name.empty() ? "the item" : "item '" + name + "'") + " does not " + why);
  };
  if (bodies.size() > 1 && !stands)
    refuse(
        "come to rest: its centre of mass lies outside its support, or a part moves on its "
        "joint, which friction, a spring, a latch or a lock would hold");
  if (!stands || !rests)
    refuse(on_casters ? "stand on its casters: its centre of mass lies outside their support"
                      : "stand on its base: its centre of mass lies outside it");
  if (const auto joint = unstable_joint(standing, settled))
    refuse(
        fmt::format("come to rest: its part '{}' stands upright and falls from there once it is "
                    "touched; a stiffer joint, friction, a latch or a lock would hold it",
                    level.items[standing.joints[*joint].joint().part].name));
  LoadsState loads = state.loads;
  mechanism.loads.adopt_springs(standing.items[0].loads, there.loads, loads);
  const auto adopt_bodies = [&](const SceneState& found) {
    std::size_t joint = 0;
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      const LoadsState own = k == 0 ? loads : all.items[bodies[k]].loads;
      all.items[bodies[k]] = found.items[k];
      all.items[bodies[k]].loads = own;
      if (const auto of_body = joint_of(scene, bodies[k]))
        all.joints[*of_body] = found.joints[joint++];
    }
  };
  const auto adopt = [&](const SceneState& found) {
    adopt_bodies(found);
    std::erase_if(all.contacts,
                  [&](const BodyContactState& c) { return c.contact.side.item == index; });
    for (BodyContactState memory : found.contacts) {
      memory.contact.side.item = index;
      all.contacts.push_back(memory);
    }
  };
  if (scene.items[index].on) {
    adopt_bodies(settled);
    return raise(assembly, scene, index, settled.contacts, all);
  }
  adopt(settled);
  const bool is_level = scene.slope == 0 && scene.cross_slope == 0;
  if (is_level && !mechanism.loads.holds_at_start()) return;

  Scene sprung = alone(scene, bodies);
  if (!mechanism.loads.holds_at_start()) sprung.items[0].loads.clear();
  stand_on_springs(sprung, below, std::nullopt);
  const Assembly free(sprung);
  SceneState trial = settled;
  trial.items[0].loads = free.items[0].loads.initial_state();
  if (!come_to_rest(free, trial)) return;
  mechanism.loads.adopt_springs(free.items[0].loads, trial.items[0].loads, loads);
  if (mechanism.loads.holds_at_start()) loads = trial.items[0].loads;
  adopt(trial);
}

}  // namespace gurney
