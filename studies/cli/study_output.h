#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "studies/analysis/scale_factors.h"
#include "studies/plan/study_job.h"
#include "studies/run/run_batch.h"
#include "studies/run/run_task.h"
#include "studies/run/study_file.h"

namespace gurney::cli {

/// Summary of all runs of a study as its results file has it, known without reading it back: a study may be
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

/// Runs that a study may have: 10 million take 28 hours on one core at 10 ms each, and 1 GB of
/// memory for their bookkeeping at most.
inline constexpr double kMaxRuns = 1e7;

std::string duration_text(double seconds);

/// "a second", "20 s", "a minute", "3 min": an estimate, as well as it is known.
std::string rounded_duration(double seconds);
std::string size_text(double bytes);

/// @throws Error for a study with more runs than kMaxRuns, with what it would take
void refuse_oversized(const study::Batch& batch);

/// Reports a study on its way on standard error: one line that is written over on a terminal;
/// elsewhere a line every ten seconds.
class StudyProgress {
 public:
  explicit StudyProgress(bool quiet);

  void operator()(const study::BatchProgress& now);

 private:
  bool quiet_, terminal_, complete_ = false;
  double shown_ = -10;
};

/// "8: the first; the second; ...", with the first six.
std::string list_of(const std::vector<std::string>& all);

/// Warnings of a study's job, each with the configurations that it is of where it is not of all.
std::vector<std::string> job_warnings(const study::StudyJob& job);

/// Records that a stated level of the study scales by more than groundmotions::kDubiousFactor, one
/// sentence each; of an IDA at its first level.
std::vector<std::string> scale_warnings(const study::Batch& batch);

}  // namespace gurney::cli
