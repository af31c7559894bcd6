#include <fmt/format.h>

#include <string>

#include "engine/base/error.h"
#include "engine/base/files.h"
#include "studies/analysis/overview.h"
#include "studies/analysis/study_data.h"
#include "studies/cli/commands.h"
#include "studies/cli/output.h"
#include "studies/cli/repeated_run.h"
#include "studies/cli/shared_options.h"
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

/// Shows finished cases by a temporary results file. Its runs will have other
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

}  // namespace gurney::cli
