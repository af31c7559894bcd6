#include <CLI/CLI.hpp>
#include <memory>

#include "engine/base/error.h"
#include "studies/cli/assessment_options.h"
#include "studies/cli/commands.h"
#include "studies/cli/explained_case.h"
#include "studies/cli/job_of_log.h"
#include "studies/cli/records_output.h"
#include "studies/cli/units_option.h"
#include "studies/page/page.h"
#include "studies/results/output_files.h"

namespace gurney::cli {
namespace {

struct ReportOptions {
  page::PageRequest request;
  std::string output;
  bool overwrite = false;
};

/// Of one run, where its job can be run again and gives the same demands.
void add_explanation(page::PageRequest& request) {
  try {
    if (is_study(request.file)) return;
    Explained found = explained(case_again(request.file, {}, request.job), request.units);
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

void add_report(CLI::App& app, std::function<int()>& action) {
  auto options = std::make_shared<ReportOptions>();
  CLI::App* const command = app.add_subcommand("report", "Write results as one HTML page");
  command
      ->add_option(
          "FILE", options->request.file,
          "The results file of a study or of one run; JSON of gurney calibrate or gurney verify")
      ->required();
  command->add_option("-o,--output", options->output, "The page (.html)")->required();
  add_limit_state_options(*command, options->request.assessed_by);
  add_hazard_option(*command, options->request.assessed_by);
  command->add_option("--job", options->request.job,
                      "The job file, for drawings of its items (default: the path in the log)");
  add_units_option(*command, options->request.units);
  command->add_flag("--overwrite", options->overwrite, "Replace a page that exists");
  command->callback([options, &action] { action = [options] { return report(*options); }; });
}

}  // namespace gurney::cli
