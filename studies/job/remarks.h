#pragma once

#include <string>
#include <vector>

namespace gurney::study {

/// What a job states in vain, apart from errors.
struct Remarks {
  std::vector<std::string> warnings;
  /// Inputs that change nothing in this job, `file:line:column: ...` each. An error in a single
  /// run, and in a study where none of its configurations needs the input.
  std::vector<std::string> without_effect;
};

}  // namespace gurney::study
