#include "studies/cli/run_command.h"

#include <filesystem>

#include "engine/base/error.h"
#include "studies/cli/run_output.h"
#include "studies/cli/run_study.h"
#include "studies/study/study_job.h"

namespace gurney {
namespace {

namespace fs = std::filesystem;

/// The default folder is made when it is missing; a folder the user names must exist.
void make_default_folder(const RunOptions& options) {
  if (!options.output.empty()) return;
  std::error_code problem;
  fs::create_directory("out", problem);
  require(!problem, "out: the folder cannot be made: " + problem.message());
}

RunOutput output_of(const RunOptions& options) {
  fs::path results = options.output;
  if (results.empty())
    results = fs::path("out") / fs::path(options.job).stem().replace_extension(".h5");
  require(results.extension() == ".h5",
          options.output + ": the results file must end in .h5 (-o FILE.h5)");
  return {results, options.job, options.overwrite, options.json, options.no_figure};
}

}  // namespace

int run_command(const RunOptions& options) {
  if (has_study(options.job)) return run_study(options);
  const auto refuse = [&](bool given, const char* option) {
    require(!given, options.job + ": is a single run, which has no use for " + option +
                        "; a study has a table [study]");
  };
  refuse(options.resume && options.threads > 0, "--resume and -j");
  refuse(options.resume, "--resume");
  refuse(options.threads > 0, "-j");
  const RunOutput output = output_of(options);
  const PreparedRun run = prepare_run(options.job);
  make_default_folder(options);
  check_output(output);
  return run_and_write(run, output).outcome == Outcome::kDiverged ? 3 : 0;
}

}  // namespace gurney
