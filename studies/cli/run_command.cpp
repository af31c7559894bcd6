#include "studies/cli/run_command.h"

#include <fmt/format.h>

#include <filesystem>

#include "engine/base/error.h"
#include "studies/cli/job_argument.h"
#include "studies/cli/run_output.h"
#include "studies/cli/run_study.h"
#include "studies/plan/study_job.h"

namespace gurney::cli {
namespace {

namespace fs = std::filesystem;

/// The default folder is made when it is missing; a folder the user names must exist.
void make_default_folder(const RunOptions& options) {
  if (!options.output.empty()) return;
  std::error_code problem;
  fs::create_directory("out", problem);
  require(!problem, "out: the folder cannot be created: " + problem.message());
}

RunOutput output_of(const RunOptions& options) {
  fs::path results = options.output;
  if (results.empty())
    results = fs::path("out") / fs::path(options.job).stem().replace_extension(".h5");
  require(results.extension() == ".h5",
          options.output + ": the results file must end in .h5 (-o FILE.h5)");
  return {results,         options.job,   options.overwrite, options.json,   options.no_figure,
          options.figures, options.quiet, options.units,     options.verbose};
}

}  // namespace

int run_command(const RunOptions& options) {
  options.figures.check();
  require_job(options.job, "run");
  if (study::has_study(options.job)) return run_study(options);
  std::string unused;
  const auto add = [&](bool given, const char* option) {
    if (given) unused += (unused.empty() ? "" : " and ") + std::string(option);
  };
  add(options.resume, "--resume");
  add(!options.shard.empty(), "--shard");
  require(unused.empty(), fmt::format("{}: is a single run, which has no use for {}; studies have "
                                      "a table [study]",
                                      options.job, unused));
  const RunOutput output = output_of(options);
  const study::PreparedRun run = study::prepare_run(options.job);
  make_default_folder(options);
  check_output(output);
  return is_failure(run_and_write(run, output).outcome) ? 3 : 0;
}

}  // namespace gurney::cli
