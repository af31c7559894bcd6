#include "studies/cli/sensitivity_command.h"

#include <fmt/format.h>

#include "engine/base/error.h"
#include "studies/cli/records_output.h"
#include "studies/report/sensitivity_report.h"

namespace gurney {

int sensitivity_command(const SensitivityCommandOptions& options) {
  const StudyData data(options.file);
  SensitivityRequest request{.demand = options.demand, .limit = options.limit, .level = {}};
  if (options.demand.empty() && options.limit.empty()) request.demand = "peak_displacement";
  if (options.level > 0) {
    require(data.study().intensity.kind != IntensityPlan::Kind::kHunt,
            options.file + ": a hunt has no levels that records share; leave --level out");
    request.level = static_cast<std::size_t>(options.level - 1);
  }
  const auto wanted = wanted_configurations(data, options.configurations);
  require(options.figure.empty() || wanted.size() == 1,
          fmt::format("--figure draws one configuration; name it with --configuration: {}",
                      fmt::join(data.configurations(), "; ")));
  std::vector<SensitivityReport> reports;
  std::size_t found = 0;
  for (const std::size_t configuration : wanted) {
    SensitivityReport report{data.configurations()[configuration], {}, ""};
    try {
      report.found = study_sensitivity({&data, configuration}, request);
      ++found;
    } catch (const Error& error) {
      if (wanted.size() == 1) throw;
      report.why_not = error.what();
    }
    reports.push_back(std::move(report));
  }
  if (found == 0) throw Error(reports.front().why_not);
  fmt::print("{}", options.json ? sensitivity_json(reports) : sensitivity_text(reports));
  if (!options.figure.empty())
    write_output(options.figure, sensitivity_figure(reports.front()), options.overwrite,
                 options.json);
  return 0;
}

}  // namespace gurney
