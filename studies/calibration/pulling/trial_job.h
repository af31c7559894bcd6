#pragma once

#include <string>
#include <vector>

#include "studies/calibration/pulling/measured_trial.h"

namespace gurney::calibration {

/// A job that repeats phases II and III of each trial under its measured force, for the measured
/// duration, as Xu, Ma & Kurata (2022, section 4.2) did: a study with one level for each trial,
/// whose `[[excitation.force]]` has the samples. Phase II starts at 0.5 s.
struct TrialJob {
  std::string text;  ///< empty: no trial can be repeated
  std::vector<std::string> left_out;
};

/// @param name  of the file or folder of the trials, for the title
TrialJob job_of_trials(const std::vector<MeasuredTrial>& trials, const std::string& name);

}  // namespace gurney::calibration
