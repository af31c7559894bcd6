#pragma once

#include <string>

#include "studies/study/exports/export.h"

namespace gurney::calibration {

/// The pulling tests of a study, one file for each (docs/formats/trial_file.md): `# origin =
/// simulated` and a note that begins with SYNTHETIC.
/// @param path  of a results file with histories
/// @throws Error where it has none, or its job is no pulling test
void export_trials(const std::string& path, const study::TakeFile& take);

}  // namespace gurney::calibration
