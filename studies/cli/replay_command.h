#pragma once

#include <cstddef>
#include <string>

#include "studies/cli/figure_output.h"
#include "studies/units/unit_system.h"

namespace gurney::cli {

struct ReplayOptions {
  std::string file;     ///< results file of a study
  std::size_t run = 0;  ///< index of the run
  std::string job;      ///< the job's file; empty: where the study's log says it was
  std::string output;   ///< results file to write; empty: beside the study's
  bool overwrite = false;
  bool json = false;
  bool no_figure = false;
  NamedFigures figures;
  study::UnitSystem units;
};

/// `gurney replay`: makes one run of a study again, with full histories, and compares its numbers
/// with those of the study.
/// @returns 0, 3 for a run that diverges, 1 where the numbers differ
/// @throws Error
int replay_command(const ReplayOptions& options);

}  // namespace gurney::cli
