#pragma once

#include <vector>

#include "engine/scene/scene.h"

namespace gurney::calibration {

/// Newton's law for a pulling test of an item whose casters are in line with the pull
/// (docs/pulling_tests.md).
///
/// With M the item's mass, J = sum I_w / R^2, f = sum (Cr / R) N, F_s the string potentiometers on
/// the item and F_w that on the weight, m the drop weight and p = I_p / r_p^2 its pulley:
///
///     pulled     a_1 = (m g - F_w - f - F_s) / (M + J + m + p),  T = m (g - a_1) - F_w - p a_1
///            or  a_1 = (F(t) - f - F_s) / (M + J) under a force, constant or measured
///     coasting   a_2 = (f + F_s) / (M + J)
struct PullTheory {
  /// Motion at a sample of the force, which is linear in between.
  struct Knot {
    double time = 0, force = 0;  ///< [s], [N]
    double acceleration = 0, velocity = 0, displacement = 0;
  };

  double mass = 0;            ///< M [kg]
  double added_mass = 0;      ///< J [kg]
  double drop_mass = 0;       ///< m; 0: a force pulls [kg]
  double string_tension = 0;  ///< F_s [N]
  double resistance = 0;      ///< f [N]
  double normal_force = 0;    ///< M g [N]

  double force = 0;         ///< T, or the mean of F over the pull [N]
  double held_force = 0;    ///< before the start: m g - F_w, or 0 [N]
  double acceleration = 0;  ///< a_1, or its mean [m/s2]
  double deceleration = 0;  ///< a_2, > 0 [m/s2]
  double start = 0;         ///< the blocks go, or the force begins [s]
  double release = 0;       ///< the weight lands, or the force ends [s]
  double stop = 0;          ///< [s]
  double release_displacement = 0, release_velocity = 0, rest_displacement = 0;  ///< [m], [m/s]
  std::vector<Knot> pull;  ///< from start to release

  double displacement_at(double time) const;
  double velocity_at(double time) const;
  double acceleration_at(double time) const;
  double force_at(double time) const;

 private:
  Knot pulled_at(double time) const;
};

/// @throws Error unless one drop weight, held by blocks, or one force without a limit of speed
///         pulls the scene's one item on casters along x, hard enough to move it
PullTheory theory_of(const Scene& scene);

}  // namespace gurney::calibration
