#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "engine/base/error.h"
#include "studies/cli/assessment_options.h"
#include "studies/cli/commands.h"
#include "studies/report/overview_report.h"
#include "studies/study/analysis/overview.h"

namespace gurney::cli {
namespace {

struct ShowOptions {
  std::string file;
  study::AssessmentRequest assessed_by;
  bool json = false;
};

template <class Overview>
int show(const Overview& overview, bool json) {
  fmt::print("{}", json ? report::overview_json(overview) : report::overview_text(overview));
  return 0;
}

int show_command(const ShowOptions& options) {
  if (study::is_study_file(options.file))
    return show(study::study_overview(options.file, options.assessed_by), options.json);
  require(options.assessed_by.empty(),
          options.file + ": is the file of one run; limit states are for that of a study");
  return show(study::run_overview(options.file), options.json);
}

}  // namespace

void add_show(CLI::App& app, std::function<int()>& action) {
  auto options = std::make_shared<ShowOptions>();
  CLI::App* const show = app.add_subcommand("show", "Summarize a results file");
  show->add_option("FILE", options->file, "The results file of a study or of one run")->required();
  add_limit_state_options(*show, options->assessed_by);
  show->add_flag("--json", options->json, "Print it as JSON");
  show->callback([options, &action] { action = [options] { return show_command(*options); }; });
}

}  // namespace gurney::cli
