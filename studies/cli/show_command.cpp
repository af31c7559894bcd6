#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "engine/base/error.h"
#include "engine/base/files.h"
#include "studies/analysis/overview.h"
#include "studies/cli/assessment_options.h"
#include "studies/cli/commands.h"
#include "studies/cli/print.h"
#include "studies/cli/scratch_folder.h"
#include "studies/cli/unfinished.h"
#include "studies/cli/units_option.h"
#include "studies/report/overview_report.h"
#include "studies/run/shard_status.h"

namespace gurney::cli {
namespace {

struct ShowOptions {
  std::string file, job;
  study::AssessmentRequest assessed_by;
  study::UnitSystem units;
  bool json = false;
};

/// Of what is finished, as a results file that is there for the moment. Its runs will have other
/// numbers once the study is complete, so that none can be repeated yet.
int show_unfinished(const ShowOptions& options) {
  const study::FinishedCases cases(options.file);
  require(cases.finished() > 0, options.file + ": no analysis case is finished yet");
  const ScratchFolder scratch;
  cases.write(scratch.file("unfinished.h5"),
              options.job.empty() ? job_of_folder(options.file) : options.job);
  study::StudyOverview overview =
      study::study_overview(scratch.file("unfinished.h5"), options.assessed_by, options.units);
  overview.file.path = options.file;
  for (study::FailedRun& each : overview.failures)
    each.command = "(can be repeated once the study is complete)";
  if (!options.json)
    fmt::print(
        "UNFINISHED: {} of {} analysis cases; all below is of these alone{}\n\n", cases.finished(),
        cases.tasks(),
        cases.damaged() > 0 ? fmt::format(", without {} damaged parts", cases.damaged()) : "");
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

}  // namespace

void add_show(CLI::App& app, std::function<int()>& action) {
  auto options = std::make_shared<ShowOptions>();
  CLI::App* const show = app.add_subcommand("show", "Summarize a results file");
  show->add_option("FILE", options->file,
                   "The results file of a study or of one run, or the folder FILE.h5.parts or "
                   "FILE.h5.shards of a study that is still running")
      ->required();
  show->add_option("--job", options->job,
                   "The job file, of such a folder (default: the path in its log)");
  add_limit_state_options(*show, options->assessed_by);
  add_units_option(*show, options->units);
  show->add_flag("--json", options->json, "Print it as JSON");
  show->callback([options, &action] { action = [options] { return show_command(*options); }; });
}

}  // namespace gurney::cli
