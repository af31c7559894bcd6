#include <fmt/format.h>

#include <filesystem>

#include "engine/base/error.h"
#include "engine/base/printable.h"
#include "studies/calibration/fit/caster_file.h"
#include "studies/cli/commands.h"
#include "studies/cli/output.h"
#include "studies/cli/process.h"
#include "studies/cli/shared_options.h"
#include "studies/figures/pulling_figures.h"
#include "studies/render/render.h"
#include "studies/report/calibration_report.h"
#include "studies/results/output_files.h"

namespace gurney::cli {
namespace {

struct CalibrateOptions {
  std::string trials, folder, base;
  NamedFigures figures;
  bool json = false, overwrite = false;
};

/// All of them or none.
void write_all(const CalibrateOptions& options, const calibration::Calibration& calibration,
               const std::vector<calibration::CasterFile>& casters, const std::string& text,
               const std::string& json) {
  std::error_code failed;
  std::filesystem::create_directories(options.folder, failed);
  require(!failed, options.folder + ": " + failed.message());
  const std::filesystem::path folder = options.folder;
  std::vector<std::pair<std::string, std::string>> all = {
      {(folder / "calibration.txt").string(), text},
      {(folder / "calibration.json").string(), json},
      {(folder / ("calibration" + options.figures.suffix())).string(),
       options.figures.bytes(figures::calibration_figure(calibration))}};
  for (const calibration::CasterFile& caster : casters)
    all.emplace_back((folder / caster.name).string(), caster.text);
  study::OutputFiles files(options.overwrite);
  for (const auto& [path, bytes] : all) files.check(path);
  const SignalsHeld until_written;
  for (const auto& [path, bytes] : all) files.stage(path, bytes);
  files.commit();
  if (options.json) return;
  fmt::print("\n");
  for (const auto& [path, bytes] : all) fmt::print("{}\n", printable(path));
}

/// Before the work: what is certain to be refused after it.
void check_folder(const CalibrateOptions& options) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  if (options.folder.empty()) return;
  require_name_of_folder(options.folder);
  if (!fs::exists(options.folder, ignored)) return;
  for (const std::string& suffix :
       {std::string(".txt"), std::string(".json"), options.figures.suffix()})
    study::OutputFiles(options.overwrite)
        .check((fs::path(options.folder) / ("calibration" + suffix)).string());
}

int run_calibrate(const CalibrateOptions& options) {
  options.figures.check();
  check_folder(options);
  const calibration::Calibration calibration =
      calibration::calibrate(calibration::read_trials(options.trials), options.trials);
  std::vector<std::string> without;
  const std::vector<calibration::CasterFile> casters =
      calibration::caster_files(calibration, options.base, without);
  require(options.folder.empty() || without.empty(),
          fmt::format("{}\nno file is written to {}; without -o the constants are printed",
                      fmt::join(without, "\n"), options.folder));
  const findings::Section facts = report::calibration_facts(calibration, casters, without);
  const std::string json = render::json(facts),
                    text = render::text(report::calibration_findings(facts));
  fmt::print("{}", options.json ? json : text);
  if (options.json)
    for (const std::string& each : without) fmt::print(stderr, "  {}\n", each);
  if (!options.folder.empty()) write_all(options, calibration, casters, text, json);
  return 0;
}

}  // namespace

void add_calibrate(Commands& commands) {
  commands.add<CalibrateOptions>(
      {"calibrate", "Estimate caster parameters from measured pulls and impacts",
       "gurney calibrate studies/calibration/example -o calibrated"},
      run_calibrate, [](Options& add, CalibrateOptions& options) {
        add.required("TRIALS", options.trials,
                     "A file of trials, or a folder of them (docs/formats/trial_file.md)");
        add("-o,--output FOLDER", options.folder,
            "A folder for the report, its figure and a file for each caster and floor");
        add("--base FILE", options.base,
            "The caster whose parameters are kept where no trial gives one (default: the "
            "catalogue's of the same name)");
        add_figure_format(add, options.figures);
        add("--overwrite", options.overwrite, "Replace files that exist");
        add("--json", options.json, "Print JSON, in SI units");
      });
}

}  // namespace gurney::cli
