#include "studies/cli/study_output.h"

#include <fmt/chrono.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <map>
#include <utility>
#include <vector>

#include "engine/base/error.h"
#include "engine/base/printable.h"
#include "engine/base/shell_word.h"
#include "studies/analysis/overview.h"
#include "studies/build_info/build_info.h"
#include "studies/cli/run_output.h"
#include "studies/cli/standard_error.h"
#include "studies/report/failed_runs.h"
#include "studies/report/overview_report.h"
#include "studies/report/scale_factors.h"
#include "studies/report/study_report.h"
#include "studies/results/output_files.h"
#include "studies/run/declared_ranges.h"

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

constexpr std::size_t kMaxRunsReadBack = 5'000, kMaxRows = 20, kMaxCurves = 12;

/// Shares of runs that exceed limit states, and the commands that answer more.
void print_shares(const study::StudyOverview& overview) {
  findings::Table shares = report::share_findings(overview);
  shares.most = kMaxRows;
  fmt::print("\n{}\n", render::text(shares));
  const std::size_t curves = overview.configurations.size() * overview.states.size();
  if (!overview.measure.empty() && curves > 0 && curves <= kMaxCurves) {
    const study::StudyData data(overview.file.path, {}, {}, overview.units);
    findings::List answers = report::answers_of(overview, data, study::fragilities_of(data));
    answers.broken = true;
    fmt::print("{}\n", render::text(findings::Section{}.add(std::move(answers))));
  }
  const std::string file = shell_word(overview.file.path);
  const std::string page =
      shell_word(fs::path(overview.file.path).replace_extension(".html").string());
  std::vector<std::string> next{"gurney show " + file};
  if (!overview.measure.empty() && !overview.states.empty())
    next.push_back("gurney fragility " + file);
  if (overview.configurations.size() > 1) next.push_back("gurney compare " + file);
  next.push_back(fmt::format("gurney report {} -o {}", file, page));
  fmt::print("{}", next_steps(next));
}

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
                 double runs_per_second, bool json, const study::UnitSystem& units) {
  const study::UndrawnRanges undrawn = study::undrawn_ranges(batch);
  const auto& [counts, factors] = summary;
  if (json) {
    findings::Section known;
    known.json("results", results.string()).json("runs", counts.runs);
    known.json("overturned", counts.overturned).json("failed", counts.failed);
    known.json("untrusted", counts.untrusted).list("ranges_not_drawn", "", undrawn.lines());
    if (factors.any()) known.add(report::scale_factor_findings(factors));
    fmt::print("{}", render::json(known));
    return;
  }
  fmt::print("runs     {}, {} overturned, {}\n", counts.runs, counts.overturned,
             report::failed_runs(counts.failed, counts.untrusted));
  if (runs_per_second > 0) fmt::print("speed    {:.1f} runs per second\n", runs_per_second);
  if (factors.any()) fmt::print("scaling  factors {}\n", factors.text());
  if (undrawn.parameters() > 0)
    fmt::print("ranges   {} parameters with a range keep their values: gurney show lists them\n",
               undrawn.parameters());
  fmt::print("results  {}\n", printable(results.string()));
  if (counts.runs <= kMaxRunsReadBack)
    print_shares(study::study_overview(results.string(), {}, units));
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
