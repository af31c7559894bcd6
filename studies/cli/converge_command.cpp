#include <CLI/CLI.hpp>
#include <memory>

#include "engine/base/parallel.h"
#include "studies/cli/commands.h"
#include "studies/cli/figure_output.h"
#include "studies/cli/job_argument.h"
#include "studies/cli/print.h"
#include "studies/cli/units_option.h"
#include "studies/figures/verification_figures.h"
#include "studies/report/convergence_report.h"

namespace gurney::cli {
namespace {

struct ConvergeOptions {
  std::string job;
  FigureFile figure;
  study::UnitSystem units;
  std::size_t runs = 20;
  double tolerance_percent = 2;
  int threads = 0;
  bool overwrite = false, json = false;
};

int converge_command(const ConvergeOptions& options) {
  const int threads = threads_or_all(options.threads);
  require_job(options.job, "converge");
  options.figure.check(options.overwrite);
  const study::Convergence found =
      study::converge(study::convergence_cases(options.job, options.runs, threads),
                      0.01 * options.tolerance_percent, threads);
  print_findings(report::convergence_findings(found, options.units), options.json);
  if (!options.figure.empty())
    options.figure.write(figures::convergence_figure(found), options.overwrite, options.json);
  return found.failed.empty() ? 0 : 3;
}

}  // namespace

void add_converge(CLI::App& app, std::function<int()>& action) {
  auto shared = std::make_shared<ConvergeOptions>();
  ConvergeOptions& options = *shared;
  CLI::App* const command =
      app.add_subcommand("converge", "Time-step, solver and stiffness convergence of a job");
  command->add_option("JOB", options.job, "The job file, of one run or of a study")->required();
  command->add_option("--runs", options.runs, "Number of sampled runs of a study (default: 20)")
      ->check(CLI::Range(1, 1000000));
  command
      ->add_option("--tolerance-percent", options.tolerance_percent,
                   "Relative change regarded as converged [%] (default: 2)")
      ->check(CLI::Range(1e-6, 100.0));
  command->add_option("-j,--threads", options.threads, "Threads (default: all hardware threads)")
      ->check(CLI::Range(1, 4096));
  add_figure_option(*command, options.figure, "Draw the changes with the time step");
  command->add_flag("--overwrite", options.overwrite, "Replace a figure that exists");
  add_units_option(*command, options.units, "m; of JSON si");
  command->add_flag("--json", options.json, "Print JSON, in SI units or those of --units");
  command->callback([shared, &action] { action = [shared] { return converge_command(*shared); }; });
}

}  // namespace gurney::cli
