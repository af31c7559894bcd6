#pragma once

#include <array>
#include <vector>

#include "engine/base/vector.h"

namespace gurney {

/// A rigid body in the plane. With both inverses 0 it stands.
struct PlanarBody {
  double inverse_mass = 0, inverse_inertia = 0;  ///< [1/kg], [1/(kg m2)]
  Vector2 position = Vector2::Zero(), velocity = Vector2::Zero();
  double yaw = 0, yaw_rate = 0;
};

/// Where two bodies meet: points of the first, each a circle of `radius`, against the plane through
/// `origin` with `normal` of the second; without a normal against the point `origin`.
struct PlanarSurfaces {
  std::vector<Vector2> points;  ///< on the first [m], its axes
  Vector2 origin;               ///< on the second [m], its axes
  Vector2 normal;               ///< from the second to the first, the second's axes; or zero
  double radius = 0;            ///< [m]
};

/// Two bodies that meet without friction, integrated by Runge-Kutta from the touch until they part,
/// with all that turns and slides meanwhile. At each point that overlaps by d
///
///     f = k d max(0, 1 + X d' / v0),
///
/// v0 being the speed of approach at the first touch.
struct PlanarImpact {
  enum class Contact {
    kFollows,  ///< the surfaces at every instant
    kStays     ///< the points on both bodies, and the normal, of the first touch
  };

  std::array<PlanarBody, 2> after;
  double duration = 0;  ///< from the first touch to the last [s]
  int touches = 0;      ///< times that the force began
  bool parted = false;  ///< nothing touches at the end, and every point moves away

  PlanarImpact(const PlanarBody& first, const PlanarBody& second, const PlanarSurfaces& surfaces,
               double stiffness, double damping_number, Contact contact = Contact::kFollows);
};

}  // namespace gurney
