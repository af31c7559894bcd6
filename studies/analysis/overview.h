#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "studies/analysis/scale_factors.h"
#include "studies/analysis/step_check.h"
#include "studies/plan/undrawn_ranges.h"
#include "studies/units/unit_system.h"

namespace gurney::study {

/// Facts that files of a study and of one run have in common.
struct FileOverview {
  struct Motion {
    std::string name;
    std::vector<std::string> files;  ///< "SHA-256 name" of each
    std::vector<std::string> warnings;
  };
  struct Assumption {
    std::string key, value, range, reason, file;
  };
  std::string path, title, program_version, git_commit, compiler, cpu_class;
  std::string job_name, job_sha256, seed;  ///< seed: empty where nothing is random
  std::vector<Motion> motions;             ///< empty: the floor is at rest
  std::vector<std::string> warnings;       ///< of a single run
  std::vector<Assumption> assumptions;     ///< each once, also where configurations share it
  double energy_closure = 0;               ///< the worst; NaN: no run has one
};

/// Counts of the runs of a configuration at an intensity.
struct LevelCounts {
  std::string configuration, level;
  std::size_t runs = 0, overturned = 0, failed = 0;
  std::vector<std::size_t> exceeded;  ///< of each limit state, among the runs that did not fail

  std::size_t counted() const { return runs - failed; }
};

struct FailedRun {
  std::size_t run = 0;
  std::string cause, command;  ///< command: what makes it again
};

/// Warnings of runs that begin alike up to their first number.
struct WarningKind {
  std::set<std::size_t> runs;
  std::string first;  ///< of them
};

struct StudyOverview {
  FileOverview file;
  struct Varied {
    std::string name;
    std::vector<std::string> levels;
  };
  /// Declared ranges that were not drawn; none: the file, of an earlier program, does not state it.
  std::optional<UndrawnRanges> undrawn;
  std::vector<std::string> missing_demands;  ///< that this program computes and the file lacks
  std::vector<Varied> factors;
  std::vector<std::string> configurations;
  std::vector<double> angles;  ///< [rad]
  std::string measure;         ///< that the levels are of; empty: factors on the records
  std::vector<std::string> levels;
  bool suite_by_level = false;  ///< each record has runs at one of several levels only
  UnitSystem units;
  int draws = 0, replicas = 1;
  std::vector<LimitState> states;
  std::size_t runs = 0, overturned = 0, failed = 0;
  std::size_t untrusted = 0;  ///< of the failed ones
  std::size_t energy_closure_run = 0;
  ScaleFactors factors_on_records;  ///< on the records, of all runs
  std::size_t warned = 0;           ///< runs with a warning
  std::vector<WarningKind> warnings;
  std::vector<LevelCounts> counts;  ///< levels of a configuration follow each other
  std::vector<FailedRun> failures;
  std::optional<StepCheck> step_check;
};

/// @param units  of the levels
/// @throws Error unless it is the results file of a study
StudyOverview study_overview(const std::string& path, const AssessmentRequest& request = {},
                             const UnitSystem& units = {});

struct RunOverview {
  FileOverview file;
  std::string outcome, cause;
  double end_time = 0;  ///< [s]
  struct Item {
    std::string name, model;
    double peak_displacement = 0, residual_displacement = 0;  ///< [m]
    double peak_velocity = 0;                                 ///< [m/s]
    double peak_tilt = 0;                                     ///< [rad]
    double time_of_overturning = -1;                          ///< [s]; -1: it did not
  };
  std::vector<Item> items;
};

/// @throws Error unless it is the results file of one run
RunOverview run_overview(const std::string& path);

/// Whether a results file is that of a study; else it is that of one run.
/// @throws Error for other files
bool is_study_file(const std::string& path);

}  // namespace gurney::study
