#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "studies/calibration/pulling/measured_trial.h"
#include "studies/exports/export.h"

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

/// The pulling tests of a study, one file for each (docs/formats/trial_file.md): `# origin =
/// simulated` and a note that begins with SYNTHETIC.
/// @param path  of a results file with histories
/// @param noise  seed of synthetic noise of the instruments; none: signals as simulated
/// @throws Error where it has none, or its job is no pulling test
void export_trials(const std::string& path, const std::optional<std::uint64_t>& noise,
                   const study::TakeFile& take);

/// A file or folder of trials as a job, NAME.toml, that repeats them under their measured force.
/// @return trials that it leaves out, each with the reason
/// @throws Error where no trial can be repeated
std::vector<std::string> export_trial_job(const std::string& path, const study::TakeFile& take);

}  // namespace gurney::calibration
