#include "studies/cli/measures_command.h"

#include <fmt/format.h>

#include "engine/base/error.h"
#include "studies/limit_states/limit_state_reader.h"
#include "studies/report/measure_report.h"

namespace gurney {

int measures_command(const MeasuresOptions& options) {
  const StudyData data(options.file);
  std::vector<std::size_t> states = sized_states(data);
  if (!options.limit.empty()) states = {index_of(data.limit_states(), options.limit)};
  require(!states.empty(),
          options.file +
              ": no limit state has a demand above a limit, so there is no size to "
              "predict");
  std::vector<MeasureReport> reports;
  for (const std::size_t configuration : wanted_configurations(data, options.configurations))
    for (const std::size_t state : states) {
      const LimitState& limit = data.limit_states()[state];
      reports.push_back({data.configurations()[configuration], limit.name, limit.words,
                         choose_measure({&data, configuration}, state)});
    }
  fmt::print("{}", options.json ? measure_json(reports) : measure_text(reports));
  return 0;
}

}  // namespace gurney
