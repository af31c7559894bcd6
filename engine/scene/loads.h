#pragma once

#include <limits>
#include <string>
#include <variant>
#include <vector>

#include "engine/base/vector.h"

/// Loads and test fixtures on an item, besides gravity and the floor's motion.
namespace gurney {

/// A force of constant direction at a point of the chassis, constant or tabulated. With a speed
/// limit it is the most that somebody pushes with: while the point moves along the direction at u,
/// the force is that of the table times (1 - u / limit) / 0.05, within 0 and 1.
struct PointForce {
  std::string name;
  Vector3 point = Vector3::Zero();       ///< item axes [m]
  Vector3 direction = Vector3::UnitX();  ///< floor axes, made a unit vector
  std::vector<double> time;              ///< increasing [s]
  std::vector<double> force;             ///< at `time`, linear between, zero outside [N]
  double speed_limit = std::numeric_limits<double>::infinity();  ///< > 0; then force >= 0 [m/s]
};

/// A force of constant magnitude at a point of the chassis: a string potentiometer.
struct StringPotentiometer {
  Vector3 point = Vector3::Zero();        ///< item axes [m]
  Vector3 direction = -Vector3::UnitX();  ///< of the pull on the chassis, floor axes
  double tension = 0;                     ///< >= 0 [N]
};

/// A weight that falls on a cable over a pulley and pulls the item.
///
/// The cable runs from `point` along `direction`, far enough for the direction to stay. Its tension
/// T is not m g while the weight moves: (m + I_p / r_p^2) x'' = m g - T - potentiometer_tension.
/// The cable is elastic and slack cables carry nothing. After `drop_height` the weight rests on the
/// floor.
struct DropWeight {
  Vector3 point = Vector3::Zero();       ///< item axes [m]
  Vector3 direction = Vector3::UnitX();  ///< of the pull, floor axes
  double mass = 0;                       ///< > 0 [kg]
  double drop_height = 0;                ///< > 0 [m]
  double pulley_inertia = 0;             ///< I_p >= 0 [kg m2]
  double pulley_radius = 0.05;           ///< r_p > 0 [m]
  double potentiometer_tension = 0;      ///< upwards on the weight, >= 0 [N]
  double cable_stiffness = 1e6;          ///< > 0 [N/m]
  double cable_damping = 500;            ///< >= 0 [N s/m]
};

/// Holds a point of the chassis against horizontal motion until `release_time`: the blocks before
/// the casters in phase I of a pulling test.
struct Blocks {
  Vector3 point = Vector3::Zero();  ///< item axes [m]
  double stiffness = 1e7;           ///< > 0 [N/m]
  double damping = 1e4;             ///< >= 0 [N s/m]
  double release_time = 0;          ///< > 0 [s]
};

using Load = std::variant<PointForce, StringPotentiometer, DropWeight, Blocks>;

/// Loads of one kind, in their order.
template <class Kind>
std::vector<Kind> loads_of(const std::vector<Load>& loads) {
  std::vector<Kind> result;
  for (const Load& load : loads)
    if (const Kind* of_kind = std::get_if<Kind>(&load)) result.push_back(*of_kind);
  return result;
}

/// Constraint of a fixture on one degree of freedom of the chassis (floor axes, at its centre of
/// mass).
struct Guide {
  enum class Kind { kFree, kHeld, kVelocity, kSpring };
  Kind kind = Kind::kFree;
  double velocity = 0;   ///< kVelocity: prescribed rate [m/s or rad/s]
  double stiffness = 0;  ///< kSpring: towards the start, >= 0 [N/m]; translations only
  double damping = 0;    ///< kSpring: >= 0 [N s/m]
};

/// A test rig: guides for x, y, z, and rotation about x, y, z.
struct Fixture {
  Guide guides[6];
};

struct InitialMotion {
  Vector3 position = Vector3::Zero();  ///< of the item's origin on the floor (z is ignored) [m]
  double yaw = 0;                      ///< [rad]
  Vector3 velocity = Vector3::Zero();  ///< of the centre of mass of the chassis [m/s]
  double yaw_rate = 0;                 ///< [rad/s]
  /// Wheels turn with the motion, also against a brake; false: they start without spin.
  bool wheels_roll = true;
};

}  // namespace gurney
