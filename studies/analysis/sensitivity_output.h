#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "studies/analysis/study_sensitivity.h"

namespace gurney::study {

/// The output whose variance is shared out, run by run.
struct SensitivityOutput {
  std::string name, units;
  std::string level;      ///< empty: all levels together
  std::string why_level;  ///< of a level that was not asked for
  std::vector<std::size_t> runs;
  std::vector<double> values;     ///< of these runs
  std::size_t left_out = 0;       ///< runs without such a demand
  std::size_t overturned = 0;     ///< of the runs
  std::vector<std::size_t> draw;  ///< of the runs, as /runs has it
};

/// @throws Error for a level or a demand that the study does not have
SensitivityOutput sensitivity_output(const ConfigurationView& side,
                                     const SensitivityRequest& request);

/// @throws Error where fewer than kFewestRuns are left, or all have the same output
void require_variation(const SensitivityOutput& output, const std::string& file);

/// The numbers of each draw of a configuration, by their names in the order of the file.
struct DrawnNumbers {
  std::vector<std::string> names;
  std::map<std::string, std::map<std::size_t, double>> values;  ///< of a name and a draw

  std::vector<double> column(const std::string& name, const std::vector<std::size_t>& draws) const;
};

DrawnNumbers drawn_numbers(const ConfigurationView& side);

}  // namespace gurney::study
