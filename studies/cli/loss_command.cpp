#include <fmt/format.h>

#include "engine/base/error.h"
#include "engine/base/number_text.h"
#include "engine/base/parallel.h"
#include "engine/base/unit_table.h"
#include "studies/cli/commands.h"
#include "studies/cli/output.h"
#include "studies/cli/shared_options.h"
#include "studies/figures/loss_figure.h"
#include "studies/loss/consequences.h"
#include "studies/loss/study_loss.h"
#include "studies/report/loss_report.h"

namespace gurney::cli {
namespace {

struct LossOptions {
  std::string file, consequences, measure;
  std::vector<double> at;
  study::AssessmentRequest assessed_by;
  study::UnitSystem units;
  FigureFile figure;
  int threads = 0;
  bool json = false;
};

int loss(const LossOptions& options) {
  options.figure.check();
  const study::StudyData data(options.file, options.assessed_by, {}, options.units);
  const auto consequences = study::Consequences::read(
      options.consequences.empty() ? study::usual_consequences() : options.consequences);
  study::LossRequest request{.measure = options.measure,
                             .threads = threads_or_all(options.threads)};
  const study::RunMeasure measure = data.measure(options.measure);
  const study::ReportUnit unit = report_unit(data, measure),
                          of_levels = unit_of_levels(data, measure);
  for (const double im : options.at) request.at.push_back(im * of_levels.in_si);
  configurations_with_runs(data, {});  // says which have none
  const auto losses = study_losses(data, consequences, request);
  options.figure.write([&] { return figures::loss_figure(consequences, losses, unit); }, true);
  print_findings(report::loss_findings(data, consequences, losses), options.json);
  return 0;
}

}  // namespace

void add_loss(Commands& commands) {
  commands.add<LossOptions>(
      {"loss", "Expected loss, time out of use and injuries of a study",
       "gurney loss ventilator.h5\n"
       "gurney loss ventilator.h5 --at 0.4 --hazard site.toml --figure loss.svg\n"
       "gurney loss ventilator.h5 --consequences prices.toml --json"},
      loss, [](Options& add, LossOptions& options) {
        add.required("FILE", options.file, "The results file of the study");
        add("--consequences FILE", options.consequences,
            "Prices and what follows from each limit state (default: those shipped)");
        add("--measure MEASURE", options.measure, "Intensity measure (default: the study's own)");
        add.single(
               "--at NUMBER", options.at,
               "Expected loss at this intensity, from curves, in the unit of the study's levels "
               "whatever --units states (of another measure: g, or SI); repeatable")
            ->check(Options::positive());
        add_hazard_option(add, options.assessed_by);
        add_units_option(add, options.units);
        add_figure_option(add, options.figure,
                          "Draw loss by level and how often it is above a value");
        add.threads(options.threads, "Threads (default: all cores)");
        add("--json", options.json, "Print JSON, in SI units or those of --units");
      });
}

}  // namespace gurney::cli
