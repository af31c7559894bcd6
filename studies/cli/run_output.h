#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/response/response.h"
#include "studies/cli/figure_output.h"
#include "studies/prepare/run_job.h"
#include "studies/units/unit_system.h"

namespace gurney::cli {

/// Where the files of one run go, and what is printed.
struct RunOutput {
  std::filesystem::path results;  ///< ends in .h5; figure and log stand beside it
  std::string job;                ///< path of the job's file, for the log
  bool overwrite = false, json = false, no_figure = false;
  NamedFigures style = {};
  bool quiet = false;
  study::UnitSystem units = {};
  bool verbose = false;  ///< print what is zero too

  std::filesystem::path figure() const;
  std::filesystem::path log() const;
};

/// @throws Error unless all files of the run can be written
void check_output(const RunOutput& output);

/// Simulates, writes the results file, the figure and the log, and prints the summary.
Response run_and_write(const study::PreparedRun& run, const RunOutput& output);

/// The last lines of a command: those that look at its results.
std::string next_steps(const std::vector<std::string>& commands);

}  // namespace gurney::cli
