#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "studies/analysis/scale_factors.h"
#include "studies/run/run_batch.h"
#include "studies/run/study_file.h"

namespace gurney::cli {

/// What its results file says of all runs of a study, known without reading it back: a study may be
/// larger than the memory.
struct StudySummary {
  study::RunCounts counts;
  study::ScaleFactors factors;
};

/// Writes the results of a study from its finished tasks, complete or not at all.
/// @param folder  for the file while it is not complete
/// @param read    the bytes of a task
/// @throws Error where it cannot be written or somebody made such a file meanwhile
StudySummary write_results(const study::Batch& batch, const std::filesystem::path& folder,
                           const std::function<std::string(std::size_t)>& read,
                           const std::filesystem::path& results, bool overwrite);

/// Prints the counts of a study, the scale factors of its motions, how many ranges were not drawn,
/// the shares of runs that exceed its limit states and the commands that look at its results.
/// @param runs_per_second  0: not measured
void print_study(const study::Batch& batch, const std::filesystem::path& results,
                 const StudySummary& summary, double runs_per_second, bool json,
                 const study::UnitSystem& units = {});

/// A line of a study's log, and one with the path of the job: time, host, versions.
/// @param how  such as "finished"; @param what  such as the number of runs
std::string log_entry(const std::string& job, const std::string& how, const std::string& what);

/// Appends to a log; where that fails, a warning.
void append_log(const std::filesystem::path& log, const std::string& entry);

}  // namespace gurney::cli
