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

/// The first one like a simulated trial: same caster, floor and alignment, mass and drop weight
/// within 2 %. None: nullptr.
const MeasuredTrial* find_matching(const SimulatedTrial& simulated,
                                   const std::vector<MeasuredTrial>& measured);

}  // namespace gurney::calibration
