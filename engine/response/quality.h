#pragma once

namespace gurney {

/// Numerical quality of a run.
struct Quality {
  static constexpr long kLargestHalvings = 6;

  double energy_closure =
      0;  ///< largest |closure| over the largest energy in play (stored, work or loss) [-]
  double numerical_loss = 0;    ///< numerical_loss over the same energy [-]
  double largest_residual = 0;  ///< worst accepted momentum residual, as a fraction of M g dt
  long steps = 0;
  long subdivided_steps = 0;   ///< steps that had to be cut because their solve did not converge
  long unconverged_steps = 0;  ///< accepted with a residual above the setting
  long event_steps = 0;        ///< extra steps that end at a located event or resolve an impact
  long rejected_steps = 0;     ///< repeated shorter because of their error
  long newton_iterations = 0;
  long collision_passes = 0;  ///< of Bullet
  long step_halvings = 0;     ///< of the time step, for RunOptions::peak_error
  double peak_change = 0;     ///< of judged demands by the last two of them, relative;
                              ///< infinite: of an outcome
};

}  // namespace gurney
