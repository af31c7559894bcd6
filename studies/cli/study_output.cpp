#include "studies/cli/study_output.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <map>
#include <utility>
#include <vector>

#include "engine/base/error.h"
#include "engine/base/shell_word.h"
#include "groundmotions/scaling/scale.h"
#include "studies/analysis/overview.h"
#include "studies/build_info/build_info.h"
#include "studies/cli/output.h"
#include "studies/cli/process.h"
#include "studies/cli/run_command.h"
#include "studies/report/overview_report.h"
#include "studies/report/study_report.h"
#include "studies/results/output_files.h"
#include "studies/run/declared_ranges.h"
#include "studies/run/estimate.h"

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
    const double stated = batch_.motions.set_of(task.configuration).stated_scale(task.record);
    for (const study::StudyRun& run : result.runs) factors_.add(number, stated * run.scale);
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
  for (const std::string& caution : report::warning_cautions(overview))
    fmt::print("{}\n", render::text(findings::Section{}.say("caution: " + caution)));
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

/// A longer line would not be written over but scroll.
std::size_t terminal_width() {
  winsize window{};
  const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &window) == 0 && window.ws_col > 1;
  return known ? window.ws_col : 100;
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
  findings::Section known;
  known.json("results", results.string()).json("runs", counts.runs);
  known.json("overturned", counts.overturned).json("failed", counts.failed);
  known.json("untrusted", counts.untrusted).list("ranges_not_drawn", "", undrawn.lines());
  known.text("runs", fmt::format("{}, {} overturned, {}", counts.runs, counts.overturned,
                                 report::failed_runs(counts.failed, counts.untrusted)));
  if (runs_per_second > 0)
    known.text("speed", fmt::format("{:.1f} runs per second", runs_per_second));
  if (factors.any()) known.add(report::scale_factor_findings(factors));
  if (undrawn.parameters() > 0)
    known.text("ranges",
               fmt::format("{} parameters with a range keep their values: gurney show lists them",
                           undrawn.parameters()));
  print_findings(known.text("results", results.string()), json);
  if (!json && counts.runs <= kMaxRunsReadBack)
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

std::string duration_text(double seconds) {
  if (seconds < 90) return fmt::format("{:.2g} s", seconds);
  if (seconds < 5400) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

std::string rounded_duration(double seconds) {
  if (seconds < 1.5) return "a second";
  if (seconds < 45)
    return fmt::format("{:.0f} s", seconds < 9.5 ? seconds : 5 * std::round(seconds / 5));
  return seconds < 90 ? "a minute" : duration_text(seconds);
}

std::string size_text(double bytes) {
  if (bytes < 1e6) return fmt::format("{:.0f} kB", std::max(1.0, bytes / 1e3));
  return bytes < 1e9 ? fmt::format("{:.0f} MB", bytes / 1e6)
                     : fmt::format("{:.1f} GB", bytes / 1e9);
}

void refuse_oversized(const study::Batch& batch) {
  if (static_cast<double>(batch.plan.runs()) <= kMaxRuns) return;
  const study::Estimate needs = study::estimate(batch);
  throw Error(fmt::format(
      "{}: the study has {} runs, which would take about {} on one core and {} of disk: at most "
      "{:.0f} runs are allowed; take fewer draws, records, angles or levels, or make several "
      "studies with other seeds",
      batch.job.file(), needs.runs, duration_text(needs.seconds(1)), size_text(needs.bytes()),
      kMaxRuns));
}

StudyProgress::StudyProgress(bool quiet) : quiet_(quiet), terminal_(isatty(STDERR_FILENO) == 1) {}

void StudyProgress::operator()(const study::BatchProgress& now) {
  if (quiet_ || complete_ || now.tasks_now == 0) return;
  const bool last = complete_ = now.done == now.tasks;
  if (!terminal_ && !last && now.seconds - shown_ < 10) return;
  shown_ = now.seconds;
  const double seconds = std::max(now.seconds, 1e-9);
  const double to_go =
      static_cast<double>(now.tasks - now.done) * seconds / static_cast<double>(now.tasks_now);
  std::string text =
      fmt::format("{:3.0f} %  {} runs, {:.1f} runs/s, {} overturned, {}{}",
                  100.0 * static_cast<double>(now.done) / static_cast<double>(now.tasks), now.runs,
                  static_cast<double>(now.runs_now) / seconds, now.overturned,
                  report::failed_runs(now.failed, now.untrusted),
                  last ? std::string()
                       : fmt::format(", {} elapsed, {} to go", duration_text(now.seconds),
                                     duration_text(to_go)));
  if (terminal_ && !last) text.resize(std::min(text.size(), terminal_width() - 1));
  write_error((terminal_ ? "\r" : "") + text + (terminal_ && !last ? "\x1b[K" : "\n"));
}

std::string list_of(const std::vector<std::string>& all) {
  constexpr std::size_t kShown = 6;
  const std::vector<std::string> shown(
      all.begin(), all.begin() + static_cast<std::ptrdiff_t>(std::min(kShown, all.size())));
  return fmt::format("{}: {}{}", all.size(), fmt::join(shown, "; "),
                     all.size() > kShown ? "; ..." : "");
}

std::vector<std::string> job_warnings(const study::StudyJob& job) {
  std::vector<std::string> order = job.notes();
  std::map<std::string, std::vector<std::string>> of;
  for (std::size_t i = 0; i < job.configurations().size(); ++i)
    for (const std::string& warning : job.job(i, {}).warnings) {
      if (!of.contains(warning)) order.push_back(warning);
      of[warning].push_back(fmt::format("{}", fmt::join(job.configurations()[i].levels, ", ")));
    }
  for (std::string& warning : order)
    if (const auto& found = of[warning];
        !found.empty() && found.size() < job.configurations().size())
      warning += " (" + list_of(found) + ")";
  return order;
}

std::vector<std::string> scale_warnings(const study::Batch& batch) {
  const study::IntensityPlan& plan = batch.job.study().intensity;
  std::vector<std::string> warnings;
  for (std::size_t set = 0; set < batch.motions.sets(); ++set) {
    const study::MotionSet& motions = batch.motions.set(set);
    for (std::size_t i = 0; i < motions.size(); ++i) {
      if (motions.name(i).empty()) continue;
      const double highest = plan.kind == study::IntensityPlan::Kind::kIda
                                 ? plan.first
                                 : motions.levels(i).back();  // they increase
      const bool is_factor = plan.kind == study::IntensityPlan::Kind::kScales;
      const std::string warning = groundmotions::dubious_factor(
          motions.stated_scale(i) * (is_factor ? highest : motions.scale_for(i, highest)));
      if (!warning.empty()) warnings.push_back(motions.name(i) + ": " + warning);
    }
  }
  return warnings;
}

}  // namespace gurney::cli
