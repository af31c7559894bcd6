#pragma once

#include <string>

#include "studies/calibration/trials/trial.h"

/// Pulls with casters that are not in line: what resists their swivelling.
namespace gurney::calibration {

/// Parameters from one crosswise pull, by the engine's run that is nearest to it.
struct CrosswiseFit {
  std::string trial, caster, floor;
  double load = 0;        ///< mean of a wheel, N [N]
  double resistance = 0;  ///< Cr / R of this trial
  double patch_width =
      0;             ///< w, with friction and swivel bearing as the caster's file has them [m]
  double shift = 0;  ///< of the start against the one found from the displacement [s]
  double force = 0;  ///< of phase II above what the load cell says [N]
  double friction_times_width = 0;  ///< mu w [m]
  /// mu w / 4 + T / N: torque at the swivel over the wheel's load, scrub and bearing T together
  /// [m].
  double torque_length = 0;
  double resistance_error = 0, torque_length_error = 0;  ///< standard errors by the residuals
  double correlation = 0;                                ///< of both
  double misfit = 0;  ///< root mean square of the residuals of displacement [m]
};

/// Gauss-Newton (with halved steps) in Cr / R, w, start, release and level of the force over the
/// displacement, with lateral displacement and yaw where they were measured, each weighted by its
/// noise. The engine gets the measured force at the pull point; item, caster, floor and payload are
/// those of the catalogue.
///
/// Scrub and the bearing's friction are apart only by the load of the wheel; one trial has one
/// load, so that only their sum is found.
/// @throws UnusableTrial where averages_of(), check_averages() or check_phases() do (from the half of
///         phase II on, when the casters are in line), the item or caster is not known or does not
///         weigh what the trial says, a phase is missing, no minimum is found, or the trial does not
///         determine it (error above a half)
CrosswiseFit fit_crosswise(const Trial& trial);

}  // namespace gurney::calibration
