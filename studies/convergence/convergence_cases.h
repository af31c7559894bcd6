#pragma once

#include <string>
#include <vector>

#include "studies/limit_states/limit_state.h"
#include "studies/run/run_task.h"

namespace gurney::study {

/// The runs of a job that stand for it: its only one, or a sample of a study's.
struct ConvergenceCases {
  std::vector<RunCase> runs;             ///< without histories
  std::vector<std::string> names;        ///< of the runs: what each is
  std::size_t of_runs = 1;               ///< that the job has; of an IDA: the most there can be
  std::vector<LimitState> limit_states;  ///< of a study; else empty
};

/// A study's runs are taken at equal distances through its plan, each at the next of its levels, so
/// that all configurations, records and levels have their share. Of an IDA they are its first
/// steps.
/// @param most  runs that are taken, >= 1
/// @throws Error with every error of the job, and for a study of which no draw makes a job
ConvergenceCases convergence_cases(const std::string& job, std::size_t most, int threads);

}  // namespace gurney::study
