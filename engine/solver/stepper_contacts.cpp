#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/solver/stepper.h"

// Contacts of bodies over steps: what they remember, and how short they make a step.
namespace gurney {
namespace {

/// Steps in half a period of a contact's spring: the rebound is then within 0.3 % of its law's.
constexpr double kStepsInImpact = 32;

}  // namespace

void Stepper::set_contacts(const std::vector<BodyContact>& contacts, SceneState& state) {
  if (contacts.empty() && contacts_.empty()) return;
  const std::size_t count = state.items.size();
  // Contacts that are found anew store another energy than those they replace: the difference is booked as a loss.
  for (std::size_t i = 0; i < count; ++i)
    accounts_[i].contact_loss += assembly_.contact_energy(i, state);
  contacts_ = contacts;
  islands_.update(contacts_, assembly_, riders_);
  memory_.match(contacts_, state.contacts);
  for (BodyContactState& memory : state.contacts) {
    memory.deflection -= memory.contact.normal * memory.contact.normal.dot(memory.deflection);
    // One that has parted may overlap again as its points move: that is no new blow.
    if (memory.compression <= 0) memory.approach_speed = approach_speed(memory.contact, state);
    // A point that is found inside another body without a blow starts unloaded: slack is the overlap that does not
    // push. It only shrinks.
    const double overlap = -assembly_.gap(memory.contact, state);
    memory.slack = std::clamp(memory.slack, 0.0, std::max(overlap, 0.0));
    if (!memory.kept_place)
      memory.slack = std::max(overlap - std::max(memory.compression, 0.0), 0.0);
    memory.contact.offset -= memory.slack;
    memory.compression = overlap - memory.slack;
  }
  for (std::size_t i = 0; i < count; ++i)
    accounts_[i].contact_loss -= assembly_.contact_energy(i, state);
}

bool Stepper::free_riders(const Island& island, SceneState& state) {
  bool any = false;
  for (std::size_t i : island.items) {
    if (!riders_.rides(i)) continue;
    if (riders_.bears(i, first_.end, first_.holding[i]) &&
        riders_.bears(i, second_.end, second_.holding[i]))
      continue;
    any = true;
    riders_.leave(i, state, accounts_, returned_);
    const auto at = static_cast<std::ptrdiff_t>(island.end_contact);
    state.contacts.insert(state.contacts.begin() + at, returned_.begin(), returned_.end());
    islands_.widen(island, returned_.size());
    for (BodyContactState& memory : returned_) memory.contact.offset += memory.slack;
    for (std::size_t c = 0; c < returned_.size(); ++c)
      contacts_.insert(contacts_.begin() + at + static_cast<std::ptrdiff_t>(c),
                       returned_[c].contact);
  }
  return any;
}

double Stepper::approach_speed(const BodyContact& contact, const SceneState& state) const {
  return std::max(0.0, -contact.normal.dot(assembly_.velocity(contact, state)));
}

void Stepper::observe_approach(const Island& island, SceneState& state) {
  rates_.clear();
  for (std::size_t c = island.first_contact; c < island.end_contact; ++c) {
    BodyContactState& memory = state.contacts[c];
    const BodyContact& contact = memory.contact;
    rates_.push_back(contact.normal.dot(assembly_.velocity(contact, state)));
    if (memory.compression <= 0) memory.approach_speed = std::max(0.0, -rates_.back());
  }
  for (std::size_t j : island.joints) {
    const JointLaw& law = assembly_.joints[j];
    if (!law.has_stops()) continue;
    const auto stops = law.approaches(state.joints[j], assembly_.joint_rate(j, state));
    for (std::size_t side = 0; side < stops.size(); ++side)
      if (stops[side].compression <= 0)
        state.joints[j].approach[side] = std::max(0.0, stops[side].speed);
  }
}

double Stepper::longest_step_at_stops(const Island& island, const SceneState& state,
                                      double remaining) const {
  double longest = remaining;
  for (std::size_t j : island.joints) {
    const JointLaw& law = assembly_.joints[j];
    if (state.joints[j].latched || !law.has_stops()) continue;
    const JointLaw::Rows rows = assembly_.rows(j, state);
    const JointLaw::Row& along = rows.rows[*rows.along];
    const std::size_t part = law.joint().part, base = law.joint().base;
    const double rate =
        along.rate(state.items[part].velocity.chassis, state.items[base].velocity.chassis);
    const double change = remaining * along.rate(predictions_[part].acceleration.chassis,
                                                 predictions_[base].acceleration.chassis);
    for (const auto& [compression, speed] : law.approaches(state.joints[j], rate)) {
      const double faster = compression > 0 ? std::abs(change) : 0;
      if (std::max(std::abs(speed), faster) < ImpactLaw::kLeastApproach) continue;
      if (compression <= 0 && -compression > 2 * speed * remaining) continue;
      const double mass = 1 / assembly_.mobility(rows, j, state);
      const double duration = std::numbers::pi * std::sqrt(mass / law.stop_stiffness());
      const double until_touch = compression < 0 ? -compression / speed : 0;
      longest = std::min(longest, std::max(duration / kStepsInImpact, 0.8 * until_touch));
    }
  }
  return longest;
}

double Stepper::longest_step(const Island& island, const SceneState& state, double remaining) {
  double longest = longest_step_at_stops(island, state, remaining);
  const auto stays_apart = [&](std::size_t c) {
    const double gap = -state.contacts[c].compression;
    return gap > 0 && gap > -2 * rates_[c - island.first_contact] * remaining;
  };
  // Contacts of each item that may push it side by side in this time; of an item alone, all.
  for (std::size_t i : island.items) contacts_of_[i] = 0;
  for (std::size_t c = island.first_contact; c < island.end_contact; ++c) {
    const BodyContact& contact = state.contacts[c].contact;
    if (island.items.size() > 1 && stays_apart(c)) continue;
    ++contacts_of_[contact.side.item];
    if (contact.between_items()) ++contacts_of_[contact.other_side.item];
  }
  for (std::size_t c = island.first_contact; c < island.end_contact; ++c) {
    const BodyContactState& memory = state.contacts[c];
    const BodyContact& contact = memory.contact;
    const double rate = rates_[c - island.first_contact], gap = -memory.compression;
    const double change = gap < 0 ? remaining * predicted_acceleration(contact, state) : 0;
    if (std::max(std::abs(rate), std::abs(change)) < ImpactLaw::kLeastApproach) continue;
    if (stays_apart(c)) continue;
    double count = contacts_of_[contact.side.item];
    if (contact.between_items()) count = std::max(count, contacts_of_[contact.other_side.item]);
    // Points side by side share the blow, and their springs add up.
    const double stiffness = assembly_.laws.of(contact).impact_stiffness() * count;
    const double duration =
        std::numbers::pi * std::sqrt(effective_mass(contact, state) / stiffness);
    // Half a period pi sqrt(m / k) of the blow takes kStepsInImpact steps; the one before ends short of the touch.
    const double until_touch = gap > 0 ? gap / -rate : 0;
    longest = std::min(longest, std::max(duration / kStepsInImpact, 0.8 * until_touch));
  }
  return longest;
}

double Stepper::effective_mass(const BodyContact& contact, const SceneState& state) const {
  const auto mobility = [&](const BodyContact::Side& side) {
    const std::size_t root = riders_.root(side.item);
    const State &own = state.items[side.item], &carrier = state.items[root];
    if (root == side.item) return assembly_.items[root].mobility(side, contact.normal, own);
    const Vector3 arm =
        own.position + assembly_.items[side.item].point(side, own) - carrier.position;
    Vector6 direction;
    direction << contact.normal, arm.cross(contact.normal);
    return assembly_.items[root].mobility(direction, carrier);
  };
  return 1 /
         (mobility(contact.side) + (contact.between_items() ? mobility(contact.other_side) : 0));
}

double Stepper::predicted_acceleration(const BodyContact& contact, const SceneState& state) const {
  const auto of = [&](const BodyContact::Side& side) {
    const Vector6& a = predictions_[side.item].acceleration.chassis;
    const Vector3 arm = assembly_.items[side.item].point(side, state.items[side.item]);
    return contact.normal.dot(a.head<3>() + a.tail<3>().cross(arm));
  };
  return of(contact.side) - (contact.between_items() ? of(contact.other_side) : 0);
}

}  // namespace gurney
