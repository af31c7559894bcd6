#pragma once

#include <numbers>

#include "engine/scene/scene.h"
#include "studies/verification/scenes/housner.h"

namespace gurney::verification {

/// A block that rocks without sliding on stiff edges that hardly rebound.
struct RockingBody {
  double alpha, radius;      ///< [rad], from an edge to the centre [m]
  double inertia = 4.0 / 3;  ///< I_O / (M R^2); 4/3: a rectangle that is thin across

  static constexpr double kMass = 200, kStiffness = 1e8, kRebound = 0.01;  // [kg], [N/m], [-]

  double width() const;   ///< [m]
  double height() const;  ///< [m]
  RockingBlock block() const;
  Scene scene() const;

  /// An edge that lands with v and leaves with e v takes e (1 - eta) from the angular velocity
  /// about it: e v = 2 b e w, up, at the lever b of the centre, and 2 M b^2 e / I_O = e (1 - eta).
  double eta_error() const { return kRebound * (1 - block().eta); }

  /// Time in which an edge takes up a load or gives it back, a quarter of a period [s].
  double loading_time() const;
};

}  // namespace gurney::verification
