#pragma once

#include <string>

#include "studies/cli/figure_output.h"
#include "studies/units/unit_system.h"

namespace gurney::cli {

struct RunOptions {
  std::string job;     ///< path of the job file
  std::string output;  ///< path of the results file; empty: out/<name of the job>.h5
  bool overwrite = false;
  bool json = false;
  bool quiet = false;    ///< print no summary and no progress
  bool verbose = false;  ///< print what is zero too
  bool no_figure = false;
  NamedFigures figures;
  study::UnitSystem units;
  bool resume = false;  ///< go on with a study that was interrupted
  std::string shard;    ///< of a study: "3/8" or "auto"; empty: all of it
  int threads = 0;      ///< of a study; 0: as many as the machine has
};

/// `gurney run`: reads the job, checks that its files can be written, simulates, writes the results
/// file, the figure and the log, and prints the summary.
/// @returns 0, or 3 for a run that failed (its files are written, with the cause)
/// @throws Error for bad input and for files that cannot be written
int run_command(const RunOptions& options);

}  // namespace gurney::cli
