#pragma once

#include <string>

namespace gurney {

struct SensitivityCommandOptions {
  std::string file;            ///< results file of a study
  std::string demand, limit;   ///< what to explain: one of them; none: peak_displacement
  std::string configurations;  ///< names, apart by commas; empty: all
  int level = 0;               ///< counted from 1; 0: all levels
  std::string figure;          ///< an .svg file to draw; empty: none
  bool overwrite = false;
  bool json = false;
};

/// `gurney sensitivity`: which of the drawn numbers rule a demand.
/// @throws Error
int sensitivity_command(const SensitivityCommandOptions& options);

}  // namespace gurney
