#include <fmt/format.h>

#include "engine/base/error.h"
#include "studies/cli/commands.h"
#include "studies/cli/output.h"
#include "studies/cli/shared_options.h"
#include "studies/figures/sensitivity_figures.h"
#include "studies/report/sensitivity_report.h"

namespace gurney::cli {
namespace {

struct SensitivityCommand {
  std::string file, demand, limit;
  study::AssessmentRequest assessed_by;
  study::UnitSystem units;
  std::vector<std::string> configurations;
  int level = 0;  ///< counted from 1; 0: that nearest to a median
  bool all_levels = false;
  FigureFile figure;
  bool overwrite = false, json = false;
};

/// The limit state that is given, else the peak displacement.
void choose_output(const SensitivityCommand& options, const study::StudyData& data,
                   study::SensitivityRequest& request) {
  if (options.assessed_by.empty()) {
    request.demand = "peak_displacement";
    return;
  }
  require(data.limit_states().size() == 1,
          "several limit states are given; --limit NAME states which to explain");
  request.limit = data.limit_states().front().name;
}

int sensitivity(const SensitivityCommand& options) {
  options.figure.check(options.overwrite);
  const study::StudyData data(options.file, options.assessed_by, {}, options.units);
  study::SensitivityRequest request{.demand = options.demand, .limit = options.limit, .level = {}};
  if (options.demand.empty() && options.limit.empty()) choose_output(options, data, request);
  request.all_levels = options.all_levels;
  if (options.level > 0) {
    require(data.study().intensity.kind != study::IntensityPlan::Kind::kIda,
            options.file + ": an IDA has no levels common to all records; omit --level");
    request.level = static_cast<std::size_t>(options.level - 1);
  }
  const auto wanted = study::wanted_configurations(data, options.configurations);
  require(options.figure.empty() || wanted.size() == 1,
          fmt::format("--figure draws one configuration; name it with --configuration: {}",
                      fmt::join(data.configurations(), "; ")));
  std::vector<report::SensitivityReport> reports;
  std::size_t found = 0;
  for (const std::size_t configuration : wanted) {
    report::SensitivityReport report{data.configurations()[configuration], {}, "", options.units};
    try {
      report.found = study::study_sensitivity({&data, configuration}, request);
      ++found;
    } catch (const Error& error) {
      if (wanted.size() == 1) throw;
      report.why_not = error.what();
    }
    reports.push_back(std::move(report));
  }
  if (found == 0) throw Error(reports.front().why_not);
  std::vector<findings::Section> known;
  for (const report::SensitivityReport& each : reports)
    known.push_back(report::sensitivity_findings(each));
  print_findings(known, options.json);
  if (!options.figure.empty())
    options.figure.write(figures::sensitivity_figure(reports.front()), options.overwrite,
                         options.json);
  return 0;
}

}  // namespace

void add_sensitivity(Commands& commands) {
  commands.add<SensitivityCommand>(
      {"sensitivity", "Rank uncertain parameters by their influence on a demand",
       "gurney sensitivity ventilator.h5 --demand peak_displacement"},
      sensitivity, [](Options& add, SensitivityCommand& options) {
        add.required("FILE", options.file, "The results file of a study with draws");
        CLI::Option* const demand =
            add("--demand", options.demand, "The demand to explain (default: peak_displacement)");
        add("--limit", options.limit, "Explain whether this limit state is exceeded")
            ->excludes(demand);
        add_limit_state_options(add, options.assessed_by);
        add.single("--configuration", options.configurations, "Configurations (default: all)");
        CLI::Option* const level =
            add("--level", options.level,
                "Runs at the N-th level, counted from 1 (default: that nearest to the median "
                "of the limit state)")
                ->check(CLI::Range(1, 1000000));
        add("--all-levels", options.all_levels, "Runs at all levels together")->excludes(level);
        add_figure_option(add, options.figure, "Draw indices and tornado of one configuration");
        add("--overwrite", options.overwrite, "Replace a figure that exists");
        add_units_option(add, options.units);
        add("--json", options.json, "Print JSON, in SI units or those of --units");
      });
}

}  // namespace gurney::cli
