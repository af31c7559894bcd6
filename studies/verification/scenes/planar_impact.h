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

/// Displacement by a yaw of the points of a face; by default nothing.
struct TurningFace {
  double ahead = 0;           ///< half the length, times the speed over 1 m/s [m]
  std::vector<bool> of_wall;  ///< as the points; empty: none
};

/// Two bodies that move along x and turn about z meet with faces across x: springs at points y of
/// the common face, integrated by Runge-Kutta from the touch on. The first comes with 1 m/s.
///
///     d = x1 - x2 - (y - y1) yaw1 + (y - y2) yaw2,  f = k d max(0, 1 + X d') for d > 0
///     m1 x1'' = -sum f,  I1 yaw1'' = sum (y - y1) f,  and the opposite for the second
///
/// With a `TurningFace` the first one's corners, which lie ahead of its centre, move across as it
/// yaws: their lever is y - y1 + ahead yaw and d is less by ahead yaw^2 / 2; at a point where the
/// wall ends the lever stays and d is more by as much.
struct FaceContact {
  /// All 0: a wall.
  struct Body {
    double inverse_mass = 0, inverse_inertia = 0;  ///< [1/kg], [1/(kg m2)]
    double y = 0;                                  ///< of its centre [m]
  };
  std::array<double, 2> speed{}, yaw_rate{};  ///< after it [m/s], [rad/s]
  double peak_force = 0;                      ///< [N]
  double contact = 0;                         ///< from the first touch to the last [s]
  int touches = 0;                            ///< times that force began
  bool parts = false;  ///< all points move apart at the end, by 0.01 m/s or more

  FaceContact(const Body& first, const Body& second, const std::vector<double>& points,
              double stiffness, double damping_number, const TurningFace& turning = {});

  /// X of a restitution e in (0, 1]: (1 + e) X = ln((1 + X) / (1 - e X)), between 0 and 1 / e.
  static double damping_number(double restitution);
};

}  // namespace gurney
