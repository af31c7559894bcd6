#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/calibration/pulling/simulated_trial.h"

namespace gurney::calibration {

/// A trial of a user's folder (docs/formats/trial_file.md) with what the method finds in it.
struct MeasuredTrial {
  Trial trial;  ///< without samples where only averages are known
  std::optional<Phases> phases;
  std::optional<TrialAverages> averages;
  std::string fault;  ///< why it is not used; empty: it is
};

/// Pulls of a file or folder; other kinds of trials are left out.
/// @throws Error with every error of every file
std::vector<MeasuredTrial> measured_trials(const std::string& path);

/// The one whose force drives a simulated trial; else the first one like it: same caster, floor and
/// alignment, mass and drop weight within 2 %. None: nullptr.
const MeasuredTrial* find_matching(const SimulatedTrial& simulated,
                                   const std::vector<MeasuredTrial>& measured);

/// A trial simulated under the force of a measured one, against it, from the start of phase II.
struct DrivenError {
  double release = 0;  ///< of the displacement when the force ends, as a fraction
  double speed = 0;    ///< of the speed then
  double rest = 0;     ///< of the displacement at the end; NaN where either left the flooring
  double largest = 0;  ///< difference of the displacements in phases II and III [m]
};
/// Nothing unless the simulated trial is driven by the measured one and both have phases.
std::optional<DrivenError> driven_error(const SimulatedTrial& simulated,
                                        const std::vector<MeasuredTrial>& measured);

}  // namespace gurney::calibration
