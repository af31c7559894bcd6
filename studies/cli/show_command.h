#pragma once

#include <string>

namespace gurney {

struct ShowOptions {
  std::string file;  ///< results file of a study or of one run
  bool json = false;
};

/// `gurney show`: what a results file holds, in plain words or as JSON.
/// @returns 0
/// @throws Error
int show_command(const ShowOptions& options);

}  // namespace gurney
