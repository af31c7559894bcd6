#pragma once

#include <optional>
#include <vector>

#include "engine/contact/rolling_resistance.h"
#include "engine/solver/contact_laws.h"
#include "engine/solver/joint_law.h"
#include "engine/solver/mechanism.h"

namespace gurney {

/// The constants of all items of a scene and of what they do to each other.
struct Assembly {
  explicit Assembly(const Scene& scene);

  std::vector<Mechanism> items;  ///< as Scene::items
  std::vector<JointLaw> joints;  ///< as Scene::joints, then the tethers between items
  std::vector<std::size_t>
      roots;  ///< of each item: what carries it over any number of joints, or itself
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

  /// Whether two items are bodies of one mechanism: joints hold them, and they do not touch.
  bool joined(std::size_t a, std::size_t b) const { return roots[a] == roots[b]; }
  bool is_part(std::size_t item) const { return roots[item] != item; }

  JointLaw::Rows rows(std::size_t joint, const SceneState& state) const;
  /// The coordinate of a joint, or where it has none the angle between the part and its base [m], [rad].
  double joint_motion(std::size_t joint, const SceneState& state) const;
  /// Rate of the coordinate of a joint; 0 where it has none [m/s], [rad/s].
  double joint_rate(std::size_t joint, const SceneState& state) const;
  /// 1 / the mass that a force along the coordinate feels of the two bodies alone, which is more than
  /// that of all that hangs on them [1/kg], [1/(kg m2)].
  double mobility(const JointLaw::Rows& rows, std::size_t joint, const SceneState& state) const;
  /// Energy in the joint of which this item is the part [J].
  double joint_energy(std::size_t item, const SceneState& state) const;

  /// Resistance of what rolls there, its directions aside; of two round bodies the smaller.
  struct Roller {
    RollingResistance resistance;
    std::size_t item = 0;
    Vector3 axis = Vector3::Zero();  ///< of a cylinder, chassis axes; of a sphere zero
  };
  std::optional<Roller> roller(const BodyContact& contact) const;

  /// Energy in the contacts whose first side is of this item [J].
  double contact_energy(std::size_t item, const SceneState& state) const;
};

}  // namespace gurney
