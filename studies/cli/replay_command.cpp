#include <fmt/format.h>

#include <filesystem>

#include "engine/base/error.h"
#include "studies/analysis/replica_spread.h"
#include "studies/cli/arguments.h"
#include "studies/cli/commands.h"
#include "studies/cli/process.h"
#include "studies/cli/repeated_run.h"
#include "studies/cli/run_command.h"
#include "studies/cli/shared_options.h"
#include "studies/results/study_reader.h"

namespace gurney::cli {
namespace {

namespace fs = std::filesystem;

struct ReplayOptions {
  std::string file;     ///< results file of a study
  std::size_t run = 0;  ///< index of the run
  std::string job;      ///< the job's file; empty: where the study's log says it was
  std::string output;   ///< results file to write; empty: beside the study's
  bool overwrite = false;
  bool json = false;
  bool no_figure = false;
  NamedFigures figures;
  study::UnitSystem units;
};

std::string spread_text(const std::optional<study::ReplicaSpread>& spread,
                        const study::UnitSystem& units) {
  if (!spread) return {};
  const study::ReportUnit unit = units.of("m");
  const std::string range = fmt::format("{:.3g} to {:.3g} {}", spread->lowest / unit.in_si,
                                        spread->highest / unit.in_si, unit.name);
  return fmt::format(
      "replicas {} of this case: peak displacement {}, median {}; {} "
      "overturned, {} failed\n",
      spread->runs, range, units.text(spread->median, "m"), spread->overturned, spread->failed);
}

fs::path results_of(const ReplayOptions& options) {
  if (!options.output.empty()) return results_file(options.output);
  const fs::path file = options.file;
  return file.parent_path() / fmt::format("{}_run_{}.h5", file.stem().string(), options.run);
}

/// `gurney replay`: makes one run of a study again, with full histories, and compares its numbers
/// with those of the study.
/// @returns 0, 3 for a run that diverges, 1 where the numbers differ
/// @throws Error
int replay_command(const ReplayOptions& options) {
  options.figures.check();
  const StudyCase study_case(options.file, options.run, options.job);
  const RunOutput output{
      results_of(options),
      study_case.job(),
      options.overwrite,
      options.json,
      options.no_figure,
      options.figures,
      false,
      options.units,
      true,
      fmt::format("study           {}\nrun             {}\n", options.file, options.run)};
  check_output(output);
  const Response response = run_and_write(study_case.prepared(), output);
  const std::string differs = study_case.difference(response);
  if (!differs.empty()) {
    print_error("{}\n", differs);
    return 1;
  }
  const study::StudyReader file(options.file);
  if (!options.json)
    fmt::print("replay   the same results as in {}\n{}", options.file,
               spread_text(study::replica_spread(file, options.run), options.units));
  return is_failure(response.outcome) ? 3 : 0;
}

}  // namespace

void add_replay(Commands& commands) {
  commands.add<ReplayOptions>(
      {"replay", "Re-run one case of a study with full output", "gurney replay ventilator.h5 12"},
      replay_command, [](Options& add, ReplayOptions& options) {
        add.required("FILE", options.file, "The results file of the study");
        add.required("RUN", options.run, "Index of the run");
        add("--job FILE", options.job, "The job file (default: the path in the study's log)");
        add("-o,--output FILE", options.output,
            "The results file (default: FILE_run_RUN.h5 beside FILE)");
        add("--overwrite", options.overwrite, "Replace files that exist");
        CLI::Option* const units = add_units_option(add, options.units);
        add("--json", options.json, "Print the summary as JSON, in SI units")->excludes(units);
        add("--no-figure", options.no_figure, "Draw no figure");
        add_figure_format(add, options.figures);
      });
}

}  // namespace gurney::cli
