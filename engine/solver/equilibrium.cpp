#include "engine/solver/equilibrium.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <variant>
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
constexpr double kFastestFall = 1;     // [1/s^2]; what falls as exp(t) or slower counts as resting

/// Implicit Euler steps that start from rest each time: M / tau^2 regularises Newton's method on
/// the static problem, and the fixed point is an equilibrium.
bool relax(const Assembly& standing, SceneState& scene) {
  StageSolver solver(standing, {1e-10, 200});
  StageSolver::Output out;
  StageSolver::Input input;
  Island all{{}, 0, scene.contacts.size()};
  for (std::size_t i = 0; i < standing.items.size(); ++i) all.items.push_back(i);
  for (std::size_t j = 0; j < standing.joints.size(); ++j) all.joints.push_back(j);
  const double time = scene.items.front().time;
  input.tau = kPseudoStep;
  input.island = &all;
  input.loads = {input.tau, time, time + input.tau, true, nullptr};
  input.guess.resize(standing.items.size());
  for (int i = 0; i < kMaxPseudoSteps; ++i) {
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
    if (motion * kPseudoStep < kRestMotion) return true;
  }
  return false;
}

/// Does as relax(), again with the latches open that would bear more than they hold, until none does.
bool come_to_rest(const Assembly& standing, SceneState& scene) {
  for (;;) {
    const bool rests = relax(standing, scene);
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

/// A way in which a joint at rest can move by itself; floor axes.
struct FreeDirection {
  std::size_t joint = 0;
  Vector3 axis;
  bool turns = true;  ///< about the axis through `point`; false: along it
  Vector3 point;
  double stiffness = 0;     ///< of the joint's spring
  std::vector<bool> moves;  ///< bodies that it takes along

  /// Motion of a point by a unit of it.
  Vector3 at(const Vector3& there) const {
    return turns ? Vector3(axis.cross(there - point)) : axis;
  }
};

/// Whether friction, a latch or a stop against which it rests holds a joint against a small push.
bool is_held(const Joint& joint, const JointState& state) {
  constexpr double kRestsOn = 1e-7;  // [m], [rad]; a stop that is only met yields by rounding
  return joint.kind == Joint::Kind::kFixed || state.latched || joint.friction > 0 ||
         state.coordinate < joint.lower - kRestsOn || state.coordinate > joint.upper + kRestsOn;
}

std::vector<FreeDirection> free_directions(const Assembly& standing, const SceneState& rest) {
  std::vector<FreeDirection> all;
  for (std::size_t j = 0; j < standing.joints.size(); ++j) {
    const Joint& joint = standing.joints[j].joint();
    if (is_held(joint, rest.joints[j])) continue;
    const State& base = rest.items[joint.base];
    FreeDirection way;
    way.joint = j;
    way.turns = joint.kind != Joint::Kind::kSlider;
    way.point = base.position +
                base.rotation * (joint.point - standing.items[joint.base].chassis.center_of_mass);
    way.stiffness = joint.stiffness;
    way.moves.assign(rest.items.size(), false);
    way.moves[joint.part] = true;
    for (const JointLaw& each : standing.joints)  // bases come before their parts
      if (way.moves[each.joint().base]) way.moves[each.joint().part] = true;
    const Vector3 axis = base.rotation * joint.axis, across = axis.unitOrthogonal();
    const auto add = [&](const Vector3& direction) {
      way.axis = direction;
      all.push_back(way);
    };
    const bool bends = joint.kind == Joint::Kind::kFlexible || joint.kind == Joint::Kind::kBall;
    if (joint.kind != Joint::Kind::kFlexible) add(axis);
    if (!bends) continue;
    add(across);
    add(axis.cross(across));
  }
  return all;
}

/// The joint of a part that leaves its rest by itself once it is touched, as a mast does that is too soft for
/// what it carries and stands exactly upright. With the rates d_i(c) of a point c by the free directions i, of
/// which j moves no more than i does, weights w and masses m = w / g of all bodies and of what stands on them,
///
///     H_ij = sum w z . (a_i x d_j) + k_i + sum k_n (z . d_i)(z . d_j),
///     M_ij = sum m d_i . d_j + a_i . I a_j,
///
/// with k_n of its wheels on the floor, the second derivatives of the potential and the mass matrix at rest:
/// H v = lambda M v with lambda < 0 falls as exp(sqrt(-lambda) t). The item itself keeps its pose.
std::optional<std::size_t> unstable_joint(const Assembly& standing, const Scene& level,
                                          const SceneState& rest) {
  const std::vector<FreeDirection> ways = free_directions(standing, rest);
  const auto count = static_cast<Eigen::Index>(ways.size());
  if (count == 0 || level.gravity == 0) return {};  // without weights nothing falls
  Eigen::MatrixXd potential = Eigen::MatrixXd::Zero(count, count), mass = potential;
  const auto add = [&](std::size_t body, const Vector3& there, double weight,
                       const Matrix3& inertia) {
    for (Eigen::Index i = 0; i < count; ++i)
      for (Eigen::Index j = i; j < count; ++j) {
        const FreeDirection &outer = ways[static_cast<std::size_t>(i)],
                            &inner = ways[static_cast<std::size_t>(j)];
        if (!outer.moves[body] || !inner.moves[body]) continue;
        const Vector3 by_inner = inner.at(there);
        if (outer.turns) potential(i, j) += weight * outer.axis.cross(by_inner).z();
        mass(i, j) += weight / level.gravity * outer.at(there).dot(by_inner);
        if (outer.turns && inner.turns) mass(i, j) += outer.axis.dot(inertia * inner.axis);
      }
  };
  const auto add_tread = [&](std::size_t body, const Vector3& there, double stiffness) {
    for (Eigen::Index i = 0; i < count; ++i)
      for (Eigen::Index j = i; j < count; ++j) {
        const FreeDirection &one = ways[static_cast<std::size_t>(i)],
                            &other = ways[static_cast<std::size_t>(j)];
        if (one.moves[body] && other.moves[body])
          potential(i, j) += stiffness * one.at(there).z() * other.at(there).z();
      }
  };
  for (std::size_t k = 1; k < level.items.size(); ++k) {
    const State& body = rest.items[k];
    const MassProperties& chassis = standing.items[k].chassis;
    const Matrix3 rotation = body.rotation.toRotationMatrix();
    add(k, body.position, standing.items[k].total_mass * level.gravity,
        rotation * chassis.inertia * rotation.transpose());
    for (std::size_t c = 0; c < standing.items[k].casters.size(); ++c) {
      const auto wheel =
          standing.items[k].casters[c].contact(body.pose(), body.casters[c].swivel_angle);
      if (wheel.height < 0)
        add_tread(k, body.position + lane(wheel.contact, 0),
                  level.items[k].model.casters[c].tread.normal_stiffness);
    }
    for (const Load& load : level.items[k].loads)
      if (const auto* carried = std::get_if<PointForce>(&load))
        add(k, body.position + rotation * (carried->point - chassis.center_of_mass),
            carried->force.front(), Matrix3::Zero());
  }
  for (Eigen::Index i = 0; i < count; ++i)
    potential(i, i) += ways[static_cast<std::size_t>(i)].stiffness;
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(
      potential.selfadjointView<Eigen::Upper>(), mass.selfadjointView<Eigen::Upper>());
  if (!(modes.eigenvalues()[0] < -kFastestFall)) return {};
  Eigen::Index most = 0;
  (modes.eigenvectors().col(0).array().square() * mass.diagonal().array()).maxCoeff(&most);
  return ways[static_cast<std::size_t>(most)].joint;
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
  for (PlacedItem& body : level.items)
    for (Caster& caster : body.model.casters) {
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
  if (const auto joint = unstable_joint(standing, level, settled))
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
