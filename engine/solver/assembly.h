#pragma once

#include <vector>

#include "engine/solver/contact_laws.h"
#include "engine/solver/mechanism.h"

namespace gurney {

/// The constants of all items of a scene and of what they do to each other.
struct Assembly {
  explicit Assembly(const Scene& scene);

  std::vector<Mechanism> items;  ///< as Scene::items
  ContactLaws laws;
  Vector3 gravity;  ///< floor axes: the floor may slope

  /// Times at which a load of any item starts, stops or changes slope.
  std::vector<double> breakpoints() const;

  /// Where a contact's first side is, relative to its chassis' centre, floor axes [m].
  Vector3 point(const BodyContact& contact, const SceneState& state) const;
  /// Distance along the normal; < 0: they overlap [m].
  double gap(const BodyContact& contact, const SceneState& state) const;
  /// Velocity of the first side relative to the other, floor axes [m/s].
  Vector3 velocity(const BodyContact& contact, const SceneState& state) const;
  /// Effective mass of the chassis alone for a normal impulse at the contact: less than all of it [kg].
  double effective_mass(const BodyContact& contact, const SceneState& state) const;

  /// Energy in the contacts whose first side is of this item [J].
  double contact_energy(std::size_t item, const SceneState& state) const;
};

}  // namespace gurney
