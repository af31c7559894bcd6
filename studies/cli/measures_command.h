#pragma once

#include <string>

namespace gurney {

struct MeasuresOptions {
  std::string file;            ///< results file of a study
  std::string limit;           ///< limit state; empty: all whose demand has a size
  std::string configurations;  ///< names, apart by commas; empty: all
  bool json = false;
};

/// `gurney measures`: which intensity measure predicts the demands of a study best.
/// @throws Error
int measures_command(const MeasuresOptions& options);

}  // namespace gurney
