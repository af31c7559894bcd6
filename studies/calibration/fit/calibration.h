#pragma once

#include <string>
#include <vector>

#include "studies/calibration/fit/constants.h"
#include "studies/calibration/fit/crosswise.h"
#include "studies/calibration/fit/rolling.h"
#include "studies/calibration/trials/phases.h"
#include "studies/calibration/trials/trial_file.h"

namespace gurney::calibration {

/// A pull and its phases, for the figure.
struct PhasedPull {
  Trial trial;
  Phases phases;
  TrialAverages averages;
};

/// What trials show of casters.
struct Calibration {
  std::string source;  ///< the file or folder
  std::vector<Constant> constants;
  std::vector<RollingTrial> rolling;    ///< pulls for calibration
  std::vector<RollingTest> tests;       ///< of them
  std::vector<CrosswiseFit> crosswise;  ///< of crosswise starts, all uses
  std::vector<Outlier> outliers;
  std::vector<Prediction> predictions;
  std::vector<std::string> unpredicted;  ///< validation trials without a constant
  std::vector<TrialFault> left_out;
  std::vector<PhasedPull> pulls;
  int read = 0;       ///< trials in the files
  int simulated = 0;  ///< of them with `origin` simulated
};

/// Checks every trial, takes its values, and makes constants of all with `use` calibration.
/// @throws Error where no trial for calibration can be used, with the reasons.
Calibration calibrate(TrialSet trials, const std::string& source);

}  // namespace gurney::calibration
