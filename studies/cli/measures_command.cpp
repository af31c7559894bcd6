
#include "engine/base/error.h"
#include "studies/cli/commands.h"
#include "studies/cli/output.h"
#include "studies/cli/shared_options.h"
#include "studies/limit_states/limit_state_reader.h"
#include "studies/report/measure_report.h"

namespace gurney::cli {
namespace {

struct MeasuresOptions {
  std::string file;
  study::AssessmentRequest assessed_by;
  study::UnitSystem units;
  std::vector<std::string> states, configurations;
  bool json = false;
};

int measures(const MeasuresOptions& options) {
  const study::StudyData data(options.file, options.assessed_by, {}, options.units);
  std::vector<std::size_t> states;
  for (const std::string& name : options.states)
    states.push_back(study::index_of(data.limit_states(), name));
  if (states.empty()) states = study::sized_states(data);
  require(!states.empty(),
          options.file +
              ": no limit state has a demand above a limit, so there is no size to "
              "predict");
  std::vector<findings::Section> known;
  for (const std::size_t configuration : study::wanted_configurations(data, options.configurations))
    for (const std::size_t state : states) {
      const study::LimitState& limit = data.limit_states()[state];
      known.push_back(report::measure_findings(
          {data.configurations()[configuration], limit.name, limit.words,
           study::choose_measure({&data, configuration}, state), options.units}));
    }
  print_findings(known, options.json);
  return 0;
}

}  // namespace

void add_measures(Commands& commands) {
  commands.add<MeasuresOptions>(
      {"measures", "Compare intensity measures: efficiency and sufficiency",
       "gurney measures ventilator.h5"},
      measures, [](Options& add, MeasuresOptions& options) {
        add.required("FILE", options.file, "The results file of the study");
        add_limit_state_options(add, options.assessed_by);
        add.single(
            "--limit", options.states,
            "Limit states whose demand is predicted (default: all with a demand above a limit)");
        add.single("--configuration", options.configurations, "Configurations (default: all)");
        add_units_option(add, options.units);
        add("--json", options.json, "Print JSON, in SI units or those of --units");
      });
}

}  // namespace gurney::cli
