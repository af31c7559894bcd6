
#include "engine/base/error.h"
#include "studies/cli/commands.h"
#include "studies/cli/output.h"
#include "studies/cli/repeated_run.h"
#include "studies/cli/shared_options.h"
#include "studies/page/page.h"
#include "studies/results/output_files.h"

namespace gurney::cli {
namespace {

struct ReportOptions {
  page::PageRequest request;
  std::string output;
  bool overwrite = false;
};

/// Explains one run, where its job can be run again and gives the same demands.
void add_explanation(page::PageRequest& request) {
  try {
    if (is_study(request.file)) return;
    Explained found = explained(repeated_run(request.file, {}, request.job), request.units);
    request.explanation = std::move(found.explanation);
    request.narrative = std::move(found.narrative);
  } catch (const Error& error) {
    request.no_explanation = error.what();
  }
}

int report(const ReportOptions& options) {
  require(options.output.ends_with(".html"),
          options.output + ": the report must end in .html (-o REPORT.html)");
  study::OutputFiles(options.overwrite).check(options.output);
  page::PageRequest request = options.request;
  if (request.job.empty()) request.job = job_of_log(request.file);
  add_explanation(request);
  write_output(options.output, page::results_page(request), options.overwrite);
  return 0;
}

}  // namespace

void add_report(Commands& commands) {
  commands.add<ReportOptions>(
      {"report", "Write a run, a study, a calibration or a verification as one HTML page",
       "gurney report ventilator.h5 -o ventilator.html\n"
       "gurney report ventilator.h5 --limit-state \"peak_displacement > 0.2 m\" -o far.html"},
      report, [](Options& add, ReportOptions& options) {
        add.required(
            "FILE", options.request.file,
            "The results file of a study or of one run; JSON of gurney calibrate or gurney verify");
        add.required("-o,--output FILE", options.output, "The page (.html)");
        add_limit_state_options(add, options.request.assessed_by);
        add_hazard_option(add, options.request.assessed_by);
        add("--job FILE", options.request.job,
            "The job file, for drawings of its items (default: the path in the log)");
        add_units_option(add, options.request.units);
        add("--overwrite", options.overwrite, "Replace a page that exists");
      });
}

}  // namespace gurney::cli
