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

/// A trial as it was read, whether or not it could be used.
struct ReadTrial {
  std::string name, file;
  int line = 0;        ///< of a table of averages; 0: the file is of this trial
  std::string sha256;  ///< of the file; empty: there is none
  TrialKind kind = TrialKind::kPull;
  TrialSetup setup;
  std::string excluded = {};  ///< why; empty: it is used
};

/// Caster parameters estimated from trials.
struct Calibration {
  std::string source;  ///< the file or folder
  std::vector<ReadTrial> trials;
  std::vector<TrialValue> values;  ///< of each trial, for calibration and for validation
  std::vector<Constant> constants;
  std::vector<RollingTrial> rolling;    ///< pulls for calibration
  std::vector<RollingTest> tests;       ///< of them
  std::vector<CrosswiseFit> crosswise;  ///< of crosswise starts, all uses
  std::vector<Outlier> outliers;
  std::vector<Prediction> predictions;
  std::vector<std::string> unpredicted;  ///< validation trials without a constant
  std::vector<TrialFault> left_out;
  std::vector<TrialFault> without_kinetic;  ///< used, but not for mu_k
  std::vector<PhasedPull> pulls;
  int read = 0;       ///< trials in the files
  int simulated = 0;  ///< of them with `origin` simulated
};

/// Checks every trial, takes its values, and makes constants of all with `use` calibration.
/// @throws Error where no trial for calibration can be used, with the reasons; where two files have
///         the same content, which would count twice
Calibration calibrate(TrialSet trials, const std::string& source);

}  // namespace gurney::calibration
