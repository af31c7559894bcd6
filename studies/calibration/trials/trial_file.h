#pragma once

#include <string>
#include <vector>

#include "studies/calibration/trials/trial.h"

/// Files of measured trials: docs/formats/trial_file.md.
namespace gurney::calibration {

struct TrialSet {
  std::vector<Trial> trials;            ///< sampled
  std::vector<TrialAverages> averages;  ///< known by their averages only
};

/// Reads one file: a trial, or a table of averages, as its `schema` says.
/// @throws Error with every error of the file.
TrialSet read_trial_file(const std::string& file);

/// Reads one file, or every .csv file of a folder in the order of their names.
/// @throws Error with every error of every file; if there is none.
TrialSet read_trials(const std::string& path);

/// The trial as text of a file that reads back equal but for rounding: 1 us, 1 mN, 0.1 um,
/// 10 um/s2, 1e-4 degrees.
/// @param note  free text, such as how a simulated trial was made; empty: none
std::string trial_file_text(const Trial& trial, const std::string& note = "");

}  // namespace gurney::calibration
