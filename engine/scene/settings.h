#pragma once

namespace gurney {

/// How one integration of a scene is made. Defaults are written here and nowhere else.
struct SimulationSettings {
  double time_step = 0.004;  ///< (0, 0.02] [s]; with a tolerance the longest step
  double tolerance = 0;      ///< > 0: as many steps as errors below this fraction of the motion
                             ///< need, [0, 0.1]; 0: fixed steps
  double residual = 1e-9;    ///< momentum residual per step, as a fraction of M g dt, (0, 1e-3]
  int max_newton_iterations = 40;  ///< per stage before the step is subdivided, 4..1000
  int max_subdivisions = 10;  ///< halvings of one step before the run counts as diverged, 0..20
  double settle_time = 60;    ///< longest time after the excitation until all rests, >= 0 [s]
  double duration = 0;        ///< > 0: stop exactly then, resting or not [s]
  double rest_speed = 1e-3;   ///< slower than this everywhere ... > 0 [m/s]
  double rest_hold = 0.5;     ///< ... for this long is rest, > 0 [s]
  double overturn_tilt = 1.0471975511965976;  ///< an item has overturned here, (0, pi/2) [rad]
  bool follow_overturning = true;             ///< goes on until all lies at rest; else ends there
  double history_step =
      0.02;  ///< spacing of the histories, rounded to whole steps; 0: none kept [s]
  bool merge_held_bodies = true;  ///< what sticks, is latched or locked moves with its carrier
  bool skip_clear_collision_passes =
      true;  ///< skip Bullet's collision pass while nothing can be near
};

/// Makes steps `factor` times as long: also those that a tolerance chooses, since the error of a
/// step grows with its cube.
void lengthen_steps(double factor, SimulationSettings& settings);

/// @throws Error naming every setting outside its range.
void validate(const SimulationSettings& settings);

}  // namespace gurney
