#include "studies/cli/study_output.h"

#include <fmt/chrono.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "engine/base/error.h"
#include "studies/build_info/build_info.h"
#include "studies/cli/standard_error.h"
#include "studies/report/failed_runs.h"
#include "studies/report/scale_factors_json.h"
#include "studies/report/wrapped.h"
#include "studies/study/results/output_files.h"
#include "studies/study/run/declared_ranges.h"

namespace gurney::cli {

namespace fs = std::filesystem;

namespace {

/// Factors on the records of a study; none where nothing shakes. Configurations may have records of
/// their own.
class FactorsOfTasks {
 public:
  explicit FactorsOfTasks(const study::Batch& batch) : batch_(batch) {
    for (std::size_t set = 0; set < batch.motions.sets(); ++set)
      for (std::size_t i = 0; i < batch.motions.set(set).size(); ++i)
        shaken_ = shaken_ || !batch.motions.set(set).name(i).empty();
  }

  void add(const study::TaskResult& result) {
    if (!shaken_) return;
    const study::Task task = batch_.plan.task(result.task);
    const std::pair key{batch_.motions.index_of(task.configuration), task.record};
    const std::size_t number = numbers_.try_emplace(key, numbers_.size()).first->second;
    for (const study::StudyRun& run : result.runs) factors_.add(number, run.scale);
  }

  const study::ScaleFactors& factors() const { return factors_; }

 private:
  const study::Batch& batch_;
  bool shaken_ = false;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> numbers_;  ///< of set and record
  study::ScaleFactors factors_;
};

}  // namespace

StudySummary write_results(const study::Batch& batch, const fs::path& folder,
                           const std::function<std::string(std::size_t)>& read,
                           const fs::path& results, bool overwrite) {
  const fs::path complete = folder / "results.h5";
  study::RunCounts counts;
  FactorsOfTasks factors(batch);
  try {
    fs::remove(complete);
    counts = study::write_study_file(complete.string(), batch, [&](std::size_t task) {
      study::TaskResult result = study::task_from_bytes(read(task));
      if (result.task == task) factors.add(result);  // else it is refused
      return result;
    });
  } catch (...) {
    std::error_code ignored;
    fs::remove(complete, ignored);
    throw;
  }
  try {
    study::put_in_place(complete.string(), results.string(), overwrite);
  } catch (const Error& error) {
    throw Error(fmt::format("{}; the finished results are in {}", error.what(), complete.string()));
  }
  return {counts, factors.factors()};
}

void print_study(const study::Batch& batch, const fs::path& results, const StudySummary& summary,
                 double runs_per_second, bool json) {
  const std::vector<std::string> undrawn = study::undrawn_ranges(batch).lines();
  const auto& [counts, factors] = summary;
  if (json) {
    nlohmann::ordered_json text{{"results", results.string()},     {"runs", counts.runs},
                                {"overturned", counts.overturned}, {"failed", counts.failed},
                                {"untrusted", counts.untrusted},   {"ranges_not_drawn", undrawn}};
    if (factors.any()) text["scale_factors"] = report::scale_factors_json(factors);
    fmt::print("{}\n", text.dump(2));
    return;
  }
  fmt::print("runs     {}, {} overturned, {}\n", counts.runs, counts.overturned,
             report::failed_runs(counts.failed, counts.untrusted));
  if (runs_per_second > 0) fmt::print("speed    {:.1f} runs per second\n", runs_per_second);
  if (factors.any()) fmt::print("scaling  factors {}\n", factors.text());
  fmt::print("declared ranges not drawn:\n");
  for (const std::string& line : undrawn) fmt::print("  {}\n", report::wrapped(line, 4, 2));
  fmt::print("results  {}\n", results.string());
}

std::string log_entry(const std::string& job, const std::string& how, const std::string& what) {
  char host[256] = "unknown";
  gethostname(host, sizeof host - 1);
  const build_info::BuildInfo build = build_info::build_info();
  const auto now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ} {} on {}: {}, gurney {} {}, CPU class {}\njob {}\n",
                     fmt::gmtime(now), how, host, what, build.program_version, build.git_commit,
                     build.cpu_class, fs::absolute(job).lexically_normal().string());
}

void append_log(const fs::path& path, const std::string& entry) {
  std::FILE* const log = std::fopen(path.c_str(), "a");
  const bool written = log != nullptr && std::fputs(entry.c_str(), log) >= 0;
  const bool closed = log != nullptr && std::fclose(log) == 0;
  if (!written || !closed) print_error("warning: {}: the log cannot be written\n", path.string());
}

}  // namespace gurney::cli
