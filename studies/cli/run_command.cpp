#include "studies/cli/run_command.h"

#include <fmt/chrono.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <optional>

#include "engine/base/error.h"
#include "engine/simulate.h"
#include "studies/build_info/build_info.h"
#include "studies/cli/run_study.h"
#include "studies/cli/signals.h"
#include "studies/report/figure.h"
#include "studies/report/summary.h"
#include "studies/results/output_files.h"
#include "studies/results/results_file.h"
#include "studies/run_job.h"
#include "studies/study/study_job.h"

namespace gurney {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

struct Paths {
  fs::path results, figure, log;
};

Paths paths_for(const RunOptions& options) {
  fs::path results = options.output;
  if (results.empty())
    results = fs::path("out") / fs::path(options.job).stem().replace_extension(".h5");
  require(results.extension() == ".h5",
          options.output + ": the results file must end in .h5 (-o FILE.h5)");
  return {results, fs::path(results).replace_extension(".svg"),
          fs::path(results).replace_extension(".log")};
}

/// The default folder is made when it is missing; a folder the user names must exist.
void make_default_folder(const RunOptions& options) {
  if (!options.output.empty()) return;
  std::error_code problem;
  fs::create_directory("out", problem);
  require(!problem, "out: the folder cannot be made: " + problem.message());
}

/// What differs between two equal runs stands here and not in the results file.
std::string log_text(const RunOptions& options, const Response& response, double seconds) {
  char host[256] = "unknown";
  gethostname(host, sizeof host - 1);
  const BuildInfo build = build_info();
  const auto now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  return fmt::format(
      "finished        {:%Y-%m-%dT%H:%M:%SZ}\nhost            {}\njob             {}\n"
      "folder          {}\nprogram         gurney {}, commit {}\nCPU class       {}\n"
      "wall time       {:.3f} s\nsimulated time  {:.3f} s\n",
      fmt::gmtime(now), host, options.job, fs::current_path().string(), build.program_version,
      build.git_commit, build.cpu_class, seconds, response.end_time);
}

void print(const RunOptions& options, const Paths& paths, const PreparedRun& run,
           const Response& response, double seconds) {
  if (options.json) {
    fmt::print("{}", summary_json(run.facts, response));
    return;
  }
  fmt::print("{}\n", summary(run.facts, response));
  if (seconds > 0)
    fmt::print("speed    {:.0f} simulated seconds per second\n", response.end_time / seconds);
  fmt::print("results  {}\n", paths.results.string());
  if (!options.no_figure) fmt::print("figure   {}\n", paths.figure.string());
}

}  // namespace

int run_command(const RunOptions& options) {
  if (has_study(options.job)) return run_study(options);
  require(!options.resume && options.threads == 0,
          options.job +
              ": is a single run, which has no use for --resume and -j; studies have a "
              "table [study]");
  const Paths paths = paths_for(options);
  const PreparedRun run = prepare_run(options.job);
  make_default_folder(options);
  OutputFiles output(options.overwrite);
  output.check(paths.results.string());
  if (!options.no_figure) output.check(paths.figure.string());
  output.check(paths.log.string());

  const auto start = Clock::now();
  const Response response = simulate(run.facts.scene, run.excitation, run.facts.settings);
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();

  {
    const SignalsHeld until_written;
    output.stage(paths.results.string(), results_image(run.facts, response));
    if (!options.no_figure) output.stage(paths.figure.string(), figure(run.facts, response));
    output.stage(paths.log.string(), log_text(options, response, seconds));
    output.commit();
  }
  print(options, paths, run, response, seconds);
  return response.outcome == Outcome::kDiverged ? 3 : 0;
}

}  // namespace gurney
