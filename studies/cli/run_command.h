#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/response/response.h"
#include "studies/cli/shared_options.h"
#include "studies/prepare/run_job.h"
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

/// Path of the results file. @throws Error unless it ends in .h5
std::filesystem::path results_of(const RunOptions& options);

/// `gurney run`: reads the job, checks that its files can be written, simulates, writes the results
/// file, the figure and the log, and prints the summary.
/// @returns 0, or 3 for a run that failed (its files are written, with the cause)
/// @throws Error for bad input and for files that cannot be written
int run_command(const RunOptions& options);

/// Runs a job with a table [study].
/// @return 0, 3 when some runs failed, 130 or 143 when it was interrupted
/// @throws Error
int run_study(const RunOptions& options);

/// Where the files of one run go, and what is printed.
struct RunOutput {
  std::filesystem::path results;  ///< ends in .h5; figure and log stand beside it
  std::string job;                ///< path of the job's file, for the log
  bool overwrite = false, json = false, no_figure = false;
  NamedFigures style = {};
  bool quiet = false;
  study::UnitSystem units = {};
  bool verbose = false;     ///< print what is zero too
  std::string origin = {};  ///< lines of the log about the study of a repeated run

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
