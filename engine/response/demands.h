#pragma once

#include <algorithm>
#include <limits>
#include <vector>

namespace gurney {

/// Engineering demand parameters of one wheel.
struct WheelDemands {
  double peak_normal_force = 0;      ///< [N]
  double peak_tangential_force = 0;  ///< [N]
  double lifted_time = 0;            ///< total [s]
  int liftoffs = 0;                  ///< number of times the wheel left the floor
  double skid_distance = 0;          ///< path of the patch while sliding [m]
  /// When a wheel that was in the air as the item overturned had left the floor; < 0: there is none
  /// [s].
  double liftoff_before_overturning = -1;
};

/// Engineering demand parameters of one marked point.
struct PointDemands {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  double peak_displacement = 0;  ///< horizontal resultant relative to the floor [m]
  /// Resultant, at all times but impacts of the item whose law is restitution [m/s2].
  double peak_absolute_acceleration = 0;
  /// Peak during impacts with a stated stiffness, which it is as uncertain as; NaN: none
  /// [m/s2].
  double impact_acceleration = kNone;
  /// During impacts whose law is restitution; NaN: none. Restitution states no force: this number
  /// rests on a numerical stiffness and is no demand [m/s2].
  double numerical_acceleration = kNone;
};

/// Engineering demand parameters of a run, at the item's origin unless they say otherwise.
struct Demands {
  double peak_displacement = 0;    ///< horizontal resultant [m]
  double peak_displacement_x = 0;  ///< largest |x| [m]
  double peak_displacement_y = 0;  ///< largest |y| [m]
  double time_of_peak_displacement = 0;
  double residual_displacement = 0;  ///< horizontal resultant at the end [m]
  double residual_displacement_x = 0;
  double residual_displacement_y = 0;
  double peak_velocity = 0;  ///< horizontal resultant, relative to the floor [m/s]
  double path_length = 0;    ///< [m]
  double peak_yaw = 0;       ///< largest |yaw| [rad]
  double residual_yaw = 0;
  double peak_tilt = 0;
  double time_of_peak_tilt = 0;
  double peak_normal_force = 0;     ///< largest of any wheel [N]
  double lifted_time = 0;           ///< while at least one wheel is off the floor [s]
  int most_wheels_lifted = 0;       ///< at once
  double time_of_overturning = -1;  ///< of what stands on no other item; < 0: not overturned [s]
  /// Where the item's z axis leans to as it overturns or topples, from the floor's x axis, -pi to pi;
  /// NaN: it did not [rad].
  double direction_of_overturning = std::numeric_limits<double>::quiet_NaN();
  /// Number of impacts of this item; those with an item that stands on it count there (Response::impacts).
  int impacts = 0;
  double largest_approach_speed = 0;  ///< of an impact [m/s]
  double largest_impulse = 0;         ///< [N s]
  double peak_impact_force =
      std::numeric_limits<double>::quiet_NaN();  ///< of compliant impacts; NaN: none [N]
  /// Largest distance along the surface above the floor that the item stands on, from its place on it
  /// [m], until it falls; NaN: it stands on the floor.
  double peak_slide = std::numeric_limits<double>::quiet_NaN();
  double time_of_fall = -1;      ///< below that surface, or come down with it; < 0: it did not [s]
  double time_of_toppling = -1;  ///< of what stands on another item; < 0: it did not [s]
  // Motion of a part on its joint; NaN: it is none, or its joint does not move so.
  double peak_travel = std::numeric_limits<double>::quiet_NaN();  ///< largest |q| of a slider [m]
  double residual_travel = std::numeric_limits<double>::quiet_NaN();  ///< q at the end [m]
  /// Largest angle of a hinge, a ball joint or a flexible one [rad], and that at the end.
  double peak_swing = std::numeric_limits<double>::quiet_NaN();
  double residual_swing = std::numeric_limits<double>::quiet_NaN();
  double time_of_release = -1;  ///< of its latch, first; < 0: it held, or there is none [s]
  /// Speed of its centre of mass as it meets a stop of its joint [m/s]; NaN: there is none.
  double largest_stop_speed = std::numeric_limits<double>::quiet_NaN();
  std::vector<WheelDemands> wheels;  ///< one for each caster
  std::vector<PointDemands> points;  ///< one for each marked point

  /// Since when it lies, overturned or toppled; < 0: it does not [s].
  double lies_from() const { return std::max(time_of_overturning, time_of_toppling); }
};

}  // namespace gurney
