#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "engine/base/error.h"
#include "studies/analysis/overview.h"
#include "studies/cli/commands.h"
#include "studies/cli/output.h"
#include "studies/cli/process.h"
#include "studies/cli/shared_options.h"
#include "studies/figures/pulling_figures.h"
#include "studies/report/pulling_report.h"
#include "studies/results/output_files.h"

namespace gurney::cli {
namespace {

namespace fs = std::filesystem;

struct PullingOptions {
  std::string file, folder, measured;
  NamedFigures figures;
  std::optional<std::size_t> run;
  std::optional<std::uint64_t> noise;
  bool json = false, overwrite = false;
};

/// Index of the run that is asked for; else the first that a measured trial is like; else the first.
std::size_t shown(const PullingOptions& options, const report::PullingReport& report) {
  const auto& trials = report.trials;
  const auto found = std::ranges::find_if(trials, [&](const calibration::SimulatedTrial& trial) {
    return options.run ? trial.run == *options.run
                       : calibration::find_matching(trial, report.measured) != nullptr;
  });
  require(!options.run || found != trials.end(),
          fmt::format("{}: has no run {} that did not fail; its last is {}", options.file,
                      options.run.value_or(0), trials.back().run));
  return found == trials.end() ? 0 : static_cast<std::size_t>(found - trials.begin());
}

int pulling(const PullingOptions& options) {
  options.figures.check();
  require(study::is_study_file(options.file),
          options.file + ": is the file of one run; gurney pulling needs that of a study");
  const study::StudyReader file(options.file);
  report::PullingReport report{options.file,
                               file.text_attribute("title"),
                               calibration::simulated_trials(file, options.noise),
                               {},
                               0,
                               options.noise};
  require(!report.trials.empty(), options.file + ": every run failed");
  if (!options.measured.empty()) report.measured = calibration::measured_trials(options.measured);
  report.shown = shown(options, report);
  std::string written;
  if (!options.folder.empty()) {
    const fs::path folder = options.folder;
    const NewFolder created(folder);
    study::OutputFiles files(options.overwrite);
    const std::pair<const char*, std::string> figures[] = {
        {"figure_4", figures::pulling_figure_4(report)},
        {"figure_6", figures::pulling_figure_6(report)},
        {"figure_7", figures::pulling_figure_7(report)},
        {"figure_11", figures::pulling_figure_11(report)}};
    const auto path = [&](const char* name) {
      return (folder / (name + options.figures.suffix())).string();
    };
    for (const auto& [name, svg] : figures) files.check(path(name));
    const SignalsHeld until_written;
    for (const auto& [name, svg] : figures) {
      files.stage(path(name), options.figures.bytes(svg));
      written += "wrote    " + path(name) + "\n";
    }
    files.commit();
  }
  print_findings(report::pulling_findings(report), options.json);
  if (!options.json) fmt::print("{}", written);
  return 0;
}

}  // namespace

void add_pulling(Commands& commands) {
  commands.add<PullingOptions>(
      {"pulling", "Evaluate the simulated pulling tests of a study",
       "gurney pulling pulling_tests.h5 -o figures"},
      pulling, [](Options& add, PullingOptions& options) {
        add.required("FILE", options.file, "The results file of the study, with histories");
        add("-o,--output FOLDER", options.folder, "Draw the figures into this folder");
        add("--run", options.run, "The run of Figures 4 and 11 (default: the first)");
        add("--measured FILE", options.measured,
            "File or folder of measured trials, to be drawn beside the simulated ones");
        add("--noise", options.noise,
            "Add synthetic noise of the instruments to the simulated signals, of this "
            "seed");
        add_figure_format(add, options.figures);
        add("--overwrite", options.overwrite, "Replace figures that exist");
        add("--json", options.json, "Print JSON, in SI units");
      });
}

}  // namespace gurney::cli
