#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <string>

#include "engine/base/error.h"
#include "engine/base/files.h"
#include "engine/base/parallel.h"
#include "engine/run/run.h"
#include "studies/analysis/demand_runs.h"
#include "studies/analysis/overview.h"
#include "studies/analysis/replica_spread.h"
#include "studies/analysis/study_data.h"
#include "studies/cli/commands.h"
#include "studies/cli/output.h"
#include "studies/cli/process.h"
#include "studies/cli/repeated_run.h"
#include "studies/cli/run_command.h"
#include "studies/cli/shared_options.h"
#include "studies/figures/explanation_figure.h"
#include "studies/playback/page.h"
#include "studies/report/explanation_report.h"
#include "studies/report/overview_report.h"
#include "studies/results/output_files.h"
#include "studies/results/results_file.h"
#include "studies/results/study_reader.h"
#include "studies/run/shard_status.h"

namespace gurney::cli {
namespace {

struct ShowOptions {
  std::string file, job;
  study::AssessmentRequest assessed_by;
  study::UnitSystem units;
  bool json = false;
};

/// Shows finished cases by a temporary results file. Its runs will have other
/// numbers once the study is complete, so that none can be repeated yet.
int show_unfinished(const ShowOptions& options) {
  const study::FinishedCases cases(options.file);
  require(cases.finished() > 0, options.file + ": no analysis case is finished yet");
  const ScratchFolder scratch;
  cases.write(scratch.file("unfinished.h5"), job_of_unfinished(cases, options.file, options.job));
  study::StudyOverview overview =
      study::study_overview(scratch.file("unfinished.h5"), options.assessed_by, options.units);
  overview.file.path = options.file;
  for (study::FailedRun& each : overview.failures)
    each.command = "(can be repeated once the study is complete)";
  if (!options.json)
    fmt::print("UNFINISHED: {} of {} analysis cases; all below is of these alone{}\n\n",
               cases.finished(), cases.tasks(),
               cases.damaged() > 0 ? fmt::format(", without {} damaged part{}", cases.damaged(),
                                                 cases.damaged() == 1 ? "" : "s")
                                   : "");
  findings::Section unfinished{"unfinished"};
  unfinished.json("analysis_cases", cases.tasks()).json("finished", cases.finished());
  print_findings(report::overview_findings(overview).add(std::move(unfinished)), options.json);
  return 0;
}

int show_command(const ShowOptions& options) {
  if (is_folder(options.file)) return show_unfinished(options);
  if (study::is_study_file(options.file)) {
    const auto overview = study::study_overview(options.file, options.assessed_by, options.units);
    print_findings(report::overview_findings(overview), options.json);
    return 0;
  }
  require(options.assessed_by.empty(),
          options.file + ": is the file of one run; limit states are for that of a study");
  const study::RunOverview overview = study::run_overview(options.file);
  print_findings(report::overview_findings(overview, options.units), options.json);
  return 0;
}

struct ExplainOptions {
  std::string file, job;
  std::optional<std::size_t> run;
  FigureFile figure;
  study::UnitSystem units;
  bool json = false, what_if = false;
  int replicas = 0;  ///< 0: one, or kReplicas where the run is chaotic
  int threads = 0;
};

constexpr std::size_t kReplicas = 20;

std::size_t replicas_of(const ExplainOptions& options, const explanation::Explanation& found) {
  if (options.replicas > 0) return static_cast<std::size_t>(options.replicas);
  const bool chaotic =
      found.predictability && found.predictability->verdict == Predictability::Verdict::kChaotic;
  return chaotic ? kReplicas : 1;
}

/// Counts the runs of variants on standard error: one line that is written over on a terminal;
/// elsewhere a line every ten seconds.
class VariantProgress {
 public:
  void operator()(std::size_t finished, std::size_t all) {
    using std::chrono::steady_clock;
    const bool last = finished == all;
    if (terminal_)
      write_error(
          fmt::format("\r{} of {} runs of variants{}", finished, all, last ? "\n" : "\x1b[K"));
    else if (steady_clock::now() - shown_ >= std::chrono::seconds(10)) {
      print_error("{} of {} runs of variants\n", finished, all);
      shown_ = steady_clock::now();
    }
  }

 private:
  bool terminal_ = isatty(STDERR_FILENO) == 1;
  std::chrono::steady_clock::time_point shown_ = std::chrono::steady_clock::now();
};

int explain(const ExplainOptions& options) {
  require(options.what_if || options.replicas == 0,
          "--replicas: are of the variants of --what-if, which is missing");
  options.figure.check();
  const RepeatedRun again = repeated_run(options.file, options.run, options.job);
  const explanation::Explanation found = explained(again, options.units).explanation;
  std::optional<explanation::WhatIf> what;
  if (options.what_if && !found.failed)
    what = explanation::what_if(again.run.facts, found, replicas_of(options, found),
                                threads_or_all(options.threads), VariantProgress());
  options.figure.write([&] { return figures::explanation_figure(found); }, options.json);
  print_findings(report::explanation_findings(found, what ? &*what : nullptr), options.json);
  return found.failed ? 3 : 0;
}

namespace fs = std::filesystem;

struct ReplayOptions {
  std::string file;     ///< results file of a study
  std::size_t run = 0;  ///< index of the run
  std::string job;      ///< the job's file; empty: where the study's log says it was
  std::string output;   ///< results file to write; empty: beside the study's
  bool overwrite = false;
  bool json = false;
  bool no_figure = false;
  NamedFigures figures;
  study::UnitSystem units;
};

std::string spread_text(const std::optional<study::ReplicaSpread>& spread,
                        const study::UnitSystem& units) {
  if (!spread) return {};
  const study::ReportUnit unit = units.of("m");
  const std::string range = fmt::format("{:.3g} to {:.3g} {}", spread->lowest / unit.in_si,
                                        spread->highest / unit.in_si, unit.name);
  return fmt::format(
      "replicas {} of this case: peak displacement {}, median {}; {} "
      "overturned, {} failed\n",
      spread->runs, range, units.text(spread->median, "m"), spread->overturned, spread->failed);
}

fs::path results_of(const ReplayOptions& options) {
  if (!options.output.empty()) return results_file(options.output);
  const fs::path file = options.file;
  return file.parent_path() / fmt::format("{}_run_{}.h5", file.stem().string(), options.run);
}

/// `gurney replay`: makes one run of a study again, with full histories, and compares its numbers
/// with those of the study.
/// @returns 0, 3 for a run that diverges, 1 where the numbers differ
/// @throws Error
int replay_command(const ReplayOptions& options) {
  options.figures.check();
  const StudyCase study_case(options.file, options.run, options.job);
  const RunOutput output{
      results_of(options),
      study_case.job(),
      options.overwrite,
      options.json,
      options.no_figure,
      options.figures,
      false,
      options.units,
      true,
      fmt::format("study           {}\nrun             {}\n", options.file, options.run)};
  check_output(output);
  const Response response = run_and_write(study_case.prepared(), output);
  const std::string differs = study_case.difference(response);
  if (!differs.empty()) {
    print_error("{}\n", differs);
    return 1;
  }
  const study::StudyReader file(options.file);
  if (!options.json)
    fmt::print("replay   the same results as in {}\n{}", options.file,
               spread_text(study::replica_spread(file, options.run), options.units));
  return is_failure(response.outcome) ? 3 : 0;
}

struct PlayOptions {
  std::string file, job, output;
  std::vector<std::size_t> runs, ghosts;
  bool all_ghosts = false, overwrite = false;
};

/// A study keeps no full histories: its run is made again.
playback::RecordedRun run_again(const PlayOptions& options, std::size_t index) {
  const StudyCase study_case(options.file, index, options.job);
  const study::PreparedRun run = study_case.prepared();
  const Response response = gurney::run(run.facts.scene, run.facts.floor, run.facts.settings);
  const std::string differs = study_case.difference(response);
  require(differs.empty(), differs);
  const ScratchFolder scratch;
  study::OutputFiles files(false);
  files.stage(scratch.file("run.h5"), study::results_image(run.facts, response));
  files.commit();
  return playback::read_recorded_run(scratch.file("run.h5"));
}

std::vector<playback::PageRun> runs_of(const PlayOptions& options) {
  if (!is_study(options.file)) {
    require(options.runs.empty() || options.runs == std::vector<std::size_t>{0},
            options.file + ": is a single run, which has no --run but 0");
    return {{"", playback::read_recorded_run(options.file)}};
  }
  require(!options.runs.empty(),
          options.file + ": is a study; choose one of its runs with --run N, or two to compare");
  std::vector<playback::PageRun> runs;
  for (const std::size_t run : options.runs)
    runs.push_back(
        {options.runs.size() == 1 ? "" : fmt::format("run {}", run), run_again(options, run)});
  return runs;
}

/// The other runs of the configuration and level of the one that is shown, or those that are named;
/// none of them failed.
std::vector<std::size_t> ghosts_of(const PlayOptions& options) {
  if (!options.all_ghosts && options.ghosts.empty()) return {};
  require(options.runs.size() == 1 && is_study(options.file),
          options.file + ": ghosts are of a study, around one of its runs: --run N --ghosts");
  const std::size_t shown = options.runs.front();
  const study::StudyData data(options.file);
  const auto configuration = data.file().numbers("runs/configuration");
  const study::RunLevels levels = study::run_levels(data);
  const auto require_run = [&](std::size_t run) {
    require(run < configuration.size(), fmt::format("{}: has no run {}; it has runs 0 to {}",
                                                    options.file, run, configuration.size() - 1));
  };
  require_run(shown);
  std::vector<std::size_t> ghosts = options.ghosts;
  for (const std::size_t run : ghosts) {
    require_run(run);
    require(
        configuration[run] == configuration[shown] && run != shown,
        fmt::format("--ghost {}: must be another run of the configuration of run {}", run, shown));
    require(std::ranges::count(ghosts, run) == 1, fmt::format("--ghost {}: is named twice", run));
  }
  if (options.all_ghosts)
    for (const std::size_t run : data.runs_of(static_cast<std::size_t>(configuration[shown])))
      if (run != shown && levels.of_run[run] == levels.of_run[shown]) ghosts.push_back(run);
  require(!ghosts.empty(),
          fmt::format("{}: has no other run of the configuration and level of run {}", options.file,
                      shown));
  constexpr std::size_t kMaxGhosts = 100;
  require(ghosts.size() <= kMaxGhosts,
          fmt::format("--ghosts: {} runs are too many, {} fit; choose some with --ghost N",
                      ghosts.size(), kMaxGhosts));
  return ghosts;
}

int play(const PlayOptions& options) {
  constexpr std::size_t kMaxRuns = 4;
  require_usage(fs::path(options.output).extension() == ".html",
                options.output + ": the page must end in .html (-o FILE.html)");
  require(options.runs.size() <= kMaxRuns,
          fmt::format("--run: at most {} runs fit beside each other", kMaxRuns));
  study::OutputFiles(options.overwrite).check(options.output);
  const std::vector<std::size_t> others = ghosts_of(options);
  const std::vector<playback::PageRun> runs = runs_of(options);
  std::vector<playback::PageRun> ghosts;
  for (const std::size_t run : others)
    ghosts.push_back({fmt::format("run {}", run), playback::ghost_of(run_again(options, run))});
  write_output(options.output, playback::playback_page(runs, ghosts), options.overwrite, false);
  return 0;
}

}  // namespace

void add_show(Commands& commands) {
  commands.add<ShowOptions>(
      {"show", "Summarize a results file", "gurney show ventilator.h5"}, show_command,
      [](Options& add, ShowOptions& options) {
        add.required("FILE", options.file,
                     "The results file of a study or of one run, or the folder FILE.h5.parts or "
                     "FILE.h5.shards of a study that is still running");
        add("--job FILE", options.job,
            "The job file, of such a folder (default: the path in its log)");
        add_limit_state_options(add, options.assessed_by);
        add_units_option(add, options.units);
        add("--json", options.json, "Print it as JSON");
      });
}

void add_explain(Commands& commands) {
  commands.add<ExplainOptions>(
      {"explain", "Explain what happened in a run, why, and what would have prevented it",
       "gurney explain shake.h5 -o why.svg\n"
       "gurney explain ventilator.h5 --run 3 --what-if"},
      explain, [](Options& add, ExplainOptions& options) {
        add.required("FILE", options.file, "The results file of one run or of a study");
        add("--run", options.run, "The run of a study");
        add("--job FILE", options.job,
            "The job file (default: the path in the log beside the file)");
        add_figure_option(add, options.figure, "A figure", "-o,--output FILE");
        add("--what-if", options.what_if, "Run variants of the case that might have prevented it");
        add("--replicas", options.replicas,
            "Runs of each variant (default: 1, or 20 where the run is chaotic)")
            ->check(CLI::Range(1, 1000));
        add.threads(options.threads, "Threads (default: all hardware threads)");
        CLI::Option* const units = add_units_option(add, options.units);
        add("--json", options.json, "Print JSON in SI units")->excludes(units);
      });
}

void add_replay(Commands& commands) {
  commands.add<ReplayOptions>(
      {"replay", "Re-run one case of a study with full output", "gurney replay ventilator.h5 12"},
      replay_command, [](Options& add, ReplayOptions& options) {
        add.required("FILE", options.file, "The results file of the study");
        add.required("RUN", options.run, "Index of the run");
        add("--job FILE", options.job, "The job file (default: the path in the study's log)");
        add("-o,--output FILE", options.output,
            "The results file (default: FILE_run_RUN.h5 beside FILE)");
        add("--overwrite", options.overwrite, "Replace files that exist");
        CLI::Option* const units = add_units_option(add, options.units);
        add("--json", options.json, "Print the summary as JSON, in SI units")->excludes(units);
        add("--no-figure", options.no_figure, "Draw no figure");
        add_figure_format(add, options.figures);
      });
}

void add_play(Commands& commands) {
  commands.add<PlayOptions>(
      {"play", "Write a page that plays a run back in three dimensions",
       "gurney play shake.h5 -o shake.html\n"
       "gurney play ventilator.h5 --run 3 --run 7 -o both.html\n"
       "gurney play ventilator.h5 --run 3 --ghosts -o suite.html"},
      play, [](Options& add, PlayOptions& options) {
        add.required("FILE", options.file, "The results file of one run or of a study");
        add.single("--run", options.runs,
                   "The run of a study, which is run again; several play side by side");
        CLI::Option* const all =
            add("--ghosts", options.all_ghosts,
                "Show all other runs of its configuration and level as ghosts");
        add.single("--ghost", options.ghosts,
                   "Another run of its configuration to show as a ghost; repeatable")
            ->excludes(all);
        add("--job FILE", options.job,
            "The study's job file (default: the path in the study's log)");
        add.required("-o,--output FILE", options.output, "The page (.html)");
        add("--overwrite", options.overwrite, "Replace a page that exists");
      });
}

}  // namespace gurney::cli
