#include <fmt/format.h>
#include <unistd.h>

#include <chrono>

#include "engine/base/error.h"
#include "engine/base/parallel.h"
#include "studies/cli/commands.h"
#include "studies/cli/output.h"
#include "studies/cli/process.h"
#include "studies/cli/repeated_run.h"
#include "studies/cli/shared_options.h"
#include "studies/figures/explanation_figure.h"
#include "studies/report/explanation_report.h"

namespace gurney::cli {
namespace {

struct ExplainOptions {
  std::string file, job;
  std::optional<std::size_t> run;
  FigureFile figure;
  study::UnitSystem units;
  bool json = false, what_if = false, overwrite = false;
  int replicas = 0;  ///< 0: one, or kReplicas where the run is chaotic
  int threads = 0;
};

constexpr std::size_t kReplicas = 20;

std::size_t replicas_of(const ExplainOptions& options, const explanation::Explanation& found) {
  if (options.replicas > 0) return static_cast<std::size_t>(options.replicas);
  const bool chaotic =
      found.predictability && found.predictability->verdict == Predictability::Verdict::kChaotic;
  return chaotic ? kReplicas : 1;
}

/// Counts the runs of variants on standard error: one line that is written over on a terminal;
/// elsewhere a line every ten seconds.
class VariantProgress {
 public:
  void operator()(std::size_t finished, std::size_t all) {
    using std::chrono::steady_clock;
    const bool last = finished == all;
    if (terminal_)
      write_error(
          fmt::format("\r{} of {} runs of variants{}", finished, all, last ? "\n" : "\x1b[K"));
    else if (steady_clock::now() - shown_ >= std::chrono::seconds(10)) {
      print_error("{} of {} runs of variants\n", finished, all);
      shown_ = steady_clock::now();
    }
  }

 private:
  bool terminal_ = isatty(STDERR_FILENO) == 1;
  std::chrono::steady_clock::time_point shown_ = std::chrono::steady_clock::now();
};

int explain(const ExplainOptions& options) {
  require(options.what_if || options.replicas == 0,
          "--replicas: are of the variants of --what-if, which is missing");
  options.figure.check(options.overwrite);
  const RepeatedRun again = repeated_run(options.file, options.run, options.job);
  const explanation::Explanation found = explained(again, options.units).explanation;
  std::optional<explanation::WhatIf> what;
  if (options.what_if && !found.failed)
    what = explanation::what_if(again.run.facts, found, replicas_of(options, found),
                                threads_or_all(options.threads), VariantProgress());
  if (!options.figure.empty())
    options.figure.write(figures::explanation_figure(found), options.overwrite, options.json);
  print_findings(report::explanation_findings(found, what ? &*what : nullptr), options.json);
  return found.failed ? 3 : 0;
}

}  // namespace

void add_explain(Commands& commands) {
  commands.add<ExplainOptions>(
      {"explain", "Explain what happened in a run, why, and what would have prevented it",
       "gurney explain shake.h5 -o why.svg\n"
       "gurney explain ventilator.h5 --run 3 --what-if"},
      explain, [](Options& add, ExplainOptions& options) {
        add.required("FILE", options.file, "The results file of one run or of a study");
        add("--run", options.run, "The run of a study");
        add("--job FILE", options.job,
            "The job file (default: the path in the log beside the file)");
        add("-o,--output FILE", options.figure.path, "A figure (.svg, .pdf or .png)");
        add_figure_style(add, options.figure);
        add("--what-if", options.what_if, "Run variants of the case that might have prevented it");
        add("--replicas", options.replicas,
            "Runs of each variant (default: 1, or 20 where the run is chaotic)")
            ->check(CLI::Range(1, 1000));
        add.threads(options.threads, "Threads (default: all hardware threads)");
        CLI::Option* const units = add_units_option(add, options.units);
        add("--json", options.json, "Print JSON in SI units")->excludes(units);
        add("--overwrite", options.overwrite, "Replace a figure that exists");
      });
}

}  // namespace gurney::cli
