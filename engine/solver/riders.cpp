#include "engine/solver/riders.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/units.h"
#include "engine/solver/item_stage.h"

namespace gurney {
namespace {

/// Points of a base, and the middle from its edges, are further apart than this [m].
constexpr double kLeastBase = 1e-4;
/// Normals of one plane differ by less.
constexpr double kOnePlane = 1e-6;

bool is_guided(const Mechanism& item) {
  return std::ranges::any_of(item.fixture.guides,
                             [](const Guide& guide) { return guide.kind != Guide::Kind::kFree; });
}

bool is_of_chassis(const BodyContact& contact) {
  return contact.side.caster < 0 && contact.other_side.caster < 0 && contact.side.round < 0 &&
         contact.other_side.round < 0;
}

}  // namespace

Riders::Riders(const Assembly& assembly, bool ride)
    : assembly_(assembly),
      joints_(assembly.items.size()),
      seats_(assembly.items.size()),
      touches_(assembly.items.size()),
      held_since_(assembly.items.size(), 0.0) {
  for (std::size_t j = 0; j < assembly.joints.size(); ++j)
    if (!assembly.joints[j].tether()) joints_[assembly.joints[j].joint().part] = j;
  if (!ride) return;
  for (std::size_t i = assembly.items.size(); i-- > 0;) {
    const Mechanism& item = assembly.items[i];
    if (item.casters.empty() && item.loads.empty() && item.tethers.empty() && !is_guided(item))
      candidates_.push_back(i);
  }
}

std::size_t Riders::root(std::size_t item) const {
  while (seats_[item].taken) item = seats_[item].carrier;
  return item;
}

void Riders::place(std::size_t item, const State& carrier, State& state) const {
  const Seat& seat = seats_[item];
  state.position = carrier.position + carrier.rotation * seat.offset;
  state.rotation = (carrier.rotation * seat.turn).normalized();
}

double Riders::energy(const BodyContactState& memory) const {
  return assembly_.laws.of(memory.contact)
      .stored_energy(memory.compression, memory.deflection.norm());
}

void Riders::observe_touches(const SceneState& state) {
  std::ranges::fill(touches_, Touch());
  for (const BodyContactState& memory : state.contacts) {
    if (!(memory.compression > 0)) continue;
    const BodyContact& contact = memory.contact;
    if (!contact.between_items()) {
      touches_[contact.side.item].firm = false;
      continue;
    }
    Touch& touch = touches_[contact.other_side.item];
    if (touch.points++ == 0) {
      touch.carrier = contact.side.item;
      touch.normal = contact.normal;
    }
    touch.stiffness += assembly_.laws.of(contact).stiffness();
    touch.firm &= touch.carrier == contact.side.item && !memory.sliding && is_of_chassis(contact) &&
                  (touch.normal - contact.normal).norm() < kOnePlane;
  }
}

std::size_t Riders::carrier_of(std::size_t item) const {
  return joints_[item] ? assembly_.joints[*joints_[item]].joint().base : touches_[item].carrier;
}

bool Riders::stands_still(std::size_t item, const SceneState& state) const {
  const State &own = state.items[item], &base = state.items[carrier_of(item)];
  const Vector6 apart =
      own.velocity.chassis - velocity(base.velocity.chassis, own.position - base.position);
  return apart.head<3>().norm() + assembly_.items[item].reach * apart.tail<3>().norm() < kStill;
}

bool Riders::is_locked(std::size_t item) const {
  if (!joints_[item]) return false;
  const JointLaw& law = assembly_.joints[*joints_[item]];
  return law.joint().kind == Joint::Kind::kFixed || law.locked();
}

bool Riders::is_held(std::size_t item, const SceneState& state) const {
  if (const auto joint = joints_[item])
    return state.joints[*joint].latched && assembly_.joints[*joint].joint().stiffness == 0;
  const Touch& touch = touches_[item];
  const double weight = assembly_.items[item].total_mass * kStandardGravity;
  return touch.firm && touch.points >= 3 && weight < kLargestYield * touch.stiffness;
}

void Riders::board(SceneState& state, std::vector<EnergyAccount>& accounts) {
  if (candidates_.empty()) return;
  observe_touches(state);
  for (std::size_t i : candidates_) {
    if (seats_[i].taken) continue;
    if (!is_locked(i)) {
      const double time = state.items[i].time;
      if (!is_held(i, state) || !stands_still(i, state)) held_since_[i] = time;
      if (time - held_since_[i] < kHoldTime) continue;
      if (!joints_[i] && !set_footing(i, state)) continue;
    }
    Seat& seat = seats_[i];
    seat.carrier = carrier_of(i);
    seat.joint = joints_[i];
    const State &own = state.items[i], &base = state.items[seat.carrier];
    seat.offset = base.rotation.conjugate() * (own.position - base.position);
    seat.turn = base.rotation.conjugate() * own.rotation;
    seat.contacts.clear();
    seat.wrench.reset();
    if (!seat.joint) take_contacts(i, state, accounts);
    seat.taken = true;
  }
}

bool Riders::set_footing(std::size_t item, const SceneState& state) {
  Footing& footing = seats_[item].footing;
  footing.normal = -(state.items[item].rotation.conjugate() * touches_[item].normal);
  footing.points.clear();
  for (const BodyContactState& memory : state.contacts) {
    if (!(memory.compression > 0) || !memory.contact.between_items()) continue;
    if (memory.contact.other_side.item != item) continue;
    footing.points.push_back(memory.contact.other_side.local);
    footing.friction = assembly_.laws.of(memory.contact).friction();
  }
  footing.middle.setZero();
  for (const Vector3& point : footing.points)
    footing.middle += point / static_cast<double>(footing.points.size());
  // An edge has all points on one side.
  footing.edges.clear();
  for (const Vector3& a : footing.points)
    for (const Vector3& b : footing.points) {
      const Vector3 across = footing.normal.cross(b - a);
      if (across.norm() < kLeastBase) continue;
      const Vector3 inwards = across.normalized();
      const auto is_inside = [&](const Vector3& p) { return inwards.dot(p - a) > -kLeastBase; };
      if (std::ranges::all_of(footing.points, is_inside)) footing.edges.push_back({a, inwards});
    }
  return !footing.edges.empty() &&
         std::ranges::all_of(footing.edges, [&](const Footing::Edge& edge) {
           return edge.inwards.dot(footing.middle - edge.point) > kLeastBase;
         });
}

void Riders::take_contacts(std::size_t item, SceneState& state,
                           std::vector<EnergyAccount>& accounts) {
  Seat& seat = seats_[item];
  const auto holds = [&](const BodyContactState& memory) {
    return memory.contact.between_items() && memory.contact.side.item == seat.carrier &&
           memory.contact.other_side.item == item;
  };
  const Quaternion to_carrier = state.items[seat.carrier].rotation.conjugate();
  for (const BodyContactState& memory : state.contacts) {
    if (!holds(memory)) continue;
    accounts[seat.carrier].work_of_neighbours -= energy(memory);
    BodyContactState& kept = seat.contacts.emplace_back(memory);
    kept.contact.normal = to_carrier * memory.contact.normal;
    kept.deflection = to_carrier * memory.deflection;
    kept.approach_speed = 0;  // what has stuck begins no new impact
  }
  std::erase_if(state.contacts, holds);
}

bool Riders::bears(const Footing& footing, const Vector3& force, const Vector3& moment) const {
  const Vector3& n = footing.normal;
  const double pressure = n.dot(force);
  if (!(pressure > 0)) return false;
  // The centre of pressure c, about which the moment has no part in the plane: n x M = N (c - middle).
  const Vector3 about_middle = moment - footing.middle.cross(force);
  const Vector3 from_middle = n.cross(about_middle) / pressure;
  const Vector3 center = footing.middle + from_middle;
  for (const Footing::Edge& edge : footing.edges)
    if (edge.inwards.dot(center - edge.point) <
        (1 - kFirm) * edge.inwards.dot(footing.middle - edge.point))
      return false;
  // Friction at the points, each with a part of the pressure, turns by at least the least arm.
  double least = std::numeric_limits<double>::infinity();
  for (const Vector3& point : footing.points) least = std::min(least, (point - center).norm());
  const double turning = std::abs(n.dot(about_middle - from_middle.cross(force)));
  const double along = (force - pressure * n).norm();
  return along * least + turning <= kFirm * footing.friction * pressure * least;
}

bool Riders::bears(std::size_t item, const SceneState& state, const Vector6& wrench) const {
  const Seat& seat = seats_[item];
  const State& own = state.items[item];
  if (seat.joint) {
    const JointLaw& law = assembly_.joints[*seat.joint];
    if (is_locked(item)) return true;
    return std::abs(law.along(state.items[seat.carrier].pose(), own.pose(), wrench)) <=
           kFirm * law.joint().latch;
  }
  const Quaternion to_own = own.rotation.conjugate();
  return bears(seat.footing, to_own * wrench.head<3>(), to_own * wrench.tail<3>());
}

/// The body at x = (u, theta) from its place has its points at d_i = u + theta x r_i, which the springs push with
///
///     f_i = -k (c_i + n . d_i) n + k_t (e_i - (1 - n n') d_i)   where c_i + n . d_i > 0, else 0,
///
/// n away from the body, e_i the deflection of what carries it against it. Newton's method on the
/// sum of f_i and of their moments; a spring that lets go or takes hold changes its matrix.
Vector6 Riders::yield(const Vector6& wrench, const Quaternion& rotation,
                      const std::vector<BodyContactState>& contacts) const {
  constexpr int kMaxIterations = 20;
  constexpr double kTolerance = 1e-9;
  Vector6 x = Vector6::Zero();
  for (int i = 0; i < kMaxIterations; ++i) {
    Vector6 missing = -wrench;
    Matrix6 slopes = Matrix6::Zero();
    for (const BodyContactState& memory : contacts) {
      const ImpactLaw& law = assembly_.laws.of(memory.contact);
      const Vector3 r = rotation * memory.contact.other_side.local, n = memory.contact.normal;
      const Vector3 moved = x.head<3>() + x.tail<3>().cross(r);
      const double compression = memory.compression + n.dot(moved);
      if (!(compression > 0)) continue;
      const double k = law.stiffness(), k_t = law.tangential_stiffness();
      const Vector3 f = k_t * (memory.deflection - moved + n.dot(moved) * n) - k * compression * n;
      missing.head<3>() += f;
      missing.tail<3>() += r.cross(f);
      slopes += slope_between(k_t * Matrix3::Identity() + (k - k_t) * n * n.transpose(), r, r);
    }
    if (missing.norm() < kTolerance * wrench.norm()) return x;
    const Eigen::LDLT<Matrix6> factors(slopes);
    if (factors.info() != Eigen::Success || !(factors.vectorD().minCoeff() > 0)) break;
    x += factors.solve(missing);
  }
  return Vector6::Zero();  // fewer points than bear it
}

/// Whether an item rides on another over any number of others, or is it.
bool Riders::is_on(std::size_t item, std::size_t below) const {
  while (item != below && seats_[item].taken) item = seats_[item].carrier;
  return item == below;
}

/// Whether a contact of the body, or of what rides on it, with others would yield to its motion.
bool Riders::presses(std::size_t item, const Vector6& shift, const SceneState& state) const {
  constexpr double kRounding = 1e-9;  // [m]
  return std::ranges::any_of(state.contacts, [&](const BodyContactState& memory) {
    const BodyContact& contact = memory.contact;
    const auto way = [&](const BodyContact::Side& side) {
      if (!is_on(side.item, item)) return 0.0;
      const Vector3 arm = state.items[side.item].position - state.items[item].position +
                          assembly_.items[side.item].point(side, state.items[side.item]);
      return contact.normal.dot(shift.head<3>() + shift.tail<3>().cross(arm));
    };
    const double closer =
        way(contact.side) - (contact.between_items() ? way(contact.other_side) : 0);
    return memory.compression > 0 && std::abs(closer) > kRounding;
  });
}

void Riders::move(std::size_t item, const Vector6& shift, SceneState& state,
                  std::vector<EnergyAccount>& accounts) const {
  for (std::size_t i = item; i < state.items.size(); ++i) {
    if (!is_on(i, item)) continue;
    State& own = state.items[i];
    const Vector3 before = own.position;
    if (i == item) {
      own.position += shift.head<3>();
      own.rotation = rotated(shift.tail<3>(), own.rotation);
    } else {
      place(i, state.items[seats_[i].carrier], own);
    }
    const Mechanism& body = assembly_.items[i];
    accounts[i].work_of_neighbours -= body.total_mass * body.gravity.dot(own.position - before);
  }
}

void Riders::leave(std::size_t item, SceneState& state, std::vector<EnergyAccount>& accounts,
                   std::vector<BodyContactState>& contacts) {
  Seat& seat = seats_[item];
  const State &own = state.items[item], &carrier = state.items[seat.carrier];
  contacts = seat.contacts;
  for (BodyContactState& memory : contacts) {
    memory.contact.normal = carrier.rotation * memory.contact.normal;
    memory.deflection = carrier.rotation * memory.deflection;
  }
  if (seat.wrench && seat.joint) {
    const JointLaw& law = assembly_.joints[*seat.joint];
    JointState& joint = state.joints[*seat.joint];
    const JointState end = law.yielded(joint, law.along(carrier.pose(), own.pose(), *seat.wrench));
    const Vector6 shift = law.shift(carrier.pose(), own.pose(), end.coordinate - joint.coordinate);
    if (!presses(item, shift, state)) {
      accounts[item].work_of_neighbours -= assembly_.joint_energy(item, state);
      move(item, shift, state, accounts);
      joint = end;
      accounts[item].work_of_neighbours += assembly_.joint_energy(item, state);
    }
  } else if (seat.wrench) {
    const Vector6 shift = yield(*seat.wrench, own.rotation, contacts);
    if (!presses(item, shift, state)) {
      for (BodyContactState& memory : contacts) {
        const Vector3 &n = memory.contact.normal,
                      r = own.rotation * memory.contact.other_side.local;
        const Vector3 moved = shift.head<3>() + shift.tail<3>().cross(r);
        memory.compression += n.dot(moved);
        memory.deflection -= moved - n.dot(moved) * n;
        if (memory.compression <= 0) memory.deflection.setZero();
      }
      move(item, shift, state, accounts);
    }
  }
  for (const BodyContactState& memory : contacts)
    accounts[seat.carrier].work_of_neighbours += energy(memory);
  seat.taken = false;
  held_since_[item] = own.time;
}

}  // namespace gurney
