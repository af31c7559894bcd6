
#include "engine/base/parallel.h"
#include "studies/cli/arguments.h"
#include "studies/cli/commands.h"
#include "studies/cli/output.h"
#include "studies/cli/shared_options.h"
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

void add_converge(Commands& commands) {
  commands.add<ConvergeOptions>(
      {"converge", "Time-step, solver and stiffness convergence of a job",
       "gurney converge studies/jobs/pulling_test.toml --figure converge.svg"},
      converge_command, [](Options& add, ConvergeOptions& options) {
        add.required("JOB", options.job, "The job file, of one run or of a study");
        add("--runs", options.runs, "Number of sampled runs of a study (default: 20)")
            ->check(CLI::Range(1, 1000000));
        add("--tolerance-percent", options.tolerance_percent,
            "Relative change regarded as converged [%] (default: 2)")
            ->check(CLI::Range(1e-6, 100.0));
        add.threads(options.threads, "Threads (default: all hardware threads)");
        add_figure_option(add, options.figure, "Draw the changes with the time step");
        add("--overwrite", options.overwrite, "Replace a figure that exists");
        add_units_option(add, options.units, "m; of JSON si");
        add("--json", options.json, "Print JSON, in SI units or those of --units");
      });
}

}  // namespace gurney::cli
