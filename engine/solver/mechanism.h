#pragma once

#include <vector>

#include "engine/caster/leg.h"
#include "engine/contact/impact_law.h"
#include "engine/scene/scene.h"
#include "engine/solver/loads.h"
#include "engine/solver/state.h"

namespace gurney {

/// The constants of one item on its casters under its loads: what a run reads and never changes.
struct Mechanism {
  Mechanism(const Scene& scene, const Excitation& excitation);

  MassProperties chassis;  ///< with payloads; item axes
  std::vector<Leg> legs;
  /// Of the chassis against the floor and each room shape, and of each wheel against those.
  std::vector<ImpactLaw> chassis_laws, wheel_laws;
  Loads loads;
  Fixture fixture;
  Vector3 gravity;    ///< floor axes: the floor may slope
  double total_mass;  ///< [kg]
  double length;      ///< characteristic, for residuals of moments [m]
  double reach;       ///< largest distance of any point of the item from the chassis' centre [m]

  /// Potential energy of gravity, any constant origin [J].
  double gravitational_energy(const State& state) const;
  double kinetic_energy(const State& state) const;
  /// Energy in treads, stuck bearings, springs, cables and contacts of bodies [J].
  double elastic_energy(const State& state) const;
  double contact_energy(const State& state) const;  ///< of bodies only [J]

  const ImpactLaw& law_of(const BodyContact& contact) const {
    return contact.leg < 0 ? chassis_laws[static_cast<std::size_t>(contact.other)]
                           : wheel_laws[static_cast<std::size_t>(contact.leg)];
  }
  /// The point of a contact, relative to the chassis' centre, floor axes; and its velocity.
  Vector3 contact_point(const BodyContact& contact, const State& state) const;
  Vector3 contact_velocity(const BodyContact& contact, const State& state) const;
  /// What a normal impulse at the contact feels of the chassis alone: less than all of it [kg].
  double effective_mass(const BodyContact& contact, const State& state) const;

  /// The item as it is placed: chassis pose, headings, initial velocity with rolling wheels; treads
  /// unloaded.
  State placed(const InitialMotion& initial) const;
  /// Sets velocities of a state: wheels roll without slip, or stand still.
  void set_in_motion(const InitialMotion& initial, State& state) const;
};

}  // namespace gurney
