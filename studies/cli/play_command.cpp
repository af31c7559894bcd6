#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "engine/base/error.h"
#include "engine/run/run.h"
#include "studies/analysis/demand_runs.h"
#include "studies/cli/commands.h"
#include "studies/cli/output.h"
#include "studies/cli/repeated_run.h"
#include "studies/playback/ghosts.h"
#include "studies/playback/page.h"
#include "studies/results/output_files.h"
#include "studies/results/results_file.h"

namespace gurney::cli {
namespace {

namespace fs = std::filesystem;

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
  require(fs::path(options.output).extension() == ".html",
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
