#pragma once

#include "studies/calibration/trials/facts.h"
#include "studies/calibration/trials/trial.h"

namespace gurney::calibration {

/// Names of files, in the order of their enumerators.
const std::vector<std::string>& names_of_kinds();
const std::vector<std::string>& names_of_locked();
const std::vector<std::string>& names_of_uses();
const std::vector<std::string>& names_of_origins();

/// Reads the keys of docs/formats/trial_file.md. Which must be there depends on the kind.
TrialSetup read_setup(Facts& facts, TrialKind kind);

}  // namespace gurney::calibration
