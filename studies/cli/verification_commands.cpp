#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "engine/base/error.h"
#include "engine/base/parallel.h"
#include "engine/base/printable.h"
#include "studies/analysis/overview.h"
#include "studies/calibration/fit/caster_file.h"
#include "studies/cli/commands.h"
#include "studies/cli/output.h"
#include "studies/cli/process.h"
#include "studies/cli/shared_options.h"
#include "studies/figures/pulling_figures.h"
#include "studies/figures/verification_figures.h"
#include "studies/render/render.h"
#include "studies/report/calibration_report.h"
#include "studies/report/verification_report.h"
#include "studies/results/output_files.h"
#include "studies/verification/family.h"
#include "studies/verification/verify.h"

namespace gurney::cli {
namespace {

using verification::CaseRun;

constexpr int kFailed = 3;

struct VerifyOptions {
  verification::Selection selection;
  bool json = false, markdown = false, overwrite = false, list = false;
  std::string figures;
  NamedFigures style;
  int threads = 0;
};

std::string figure_path(const VerifyOptions& options, const CaseRun& run) {
  std::string name = run.name();
  name[name.find('/')] = '_';
  return fmt::format("{}/{}{}", options.figures, name, options.style.suffix());
}

void write_figures(const VerifyOptions& options, const std::vector<CaseRun>& runs) {
  study::OutputFiles files(options.overwrite);
  for (const CaseRun& run : runs)
    if (const std::string figure = figures::verification_figure(run); !figure.empty())
      files.stage(figure_path(options, run), options.style.bytes(figure));
  files.commit();
}

/// A line for each group with its families; each family's cases are FAMILY/CASE.
int list_names(const std::vector<verification::Family>& families) {
  std::vector<std::pair<std::string, std::vector<std::string>>> groups;
  for (const verification::Family& family : families) {
    const auto group = std::ranges::find(groups, family.statement.group,
                                         [](const auto& each) { return each.first; });
    const std::string name = fmt::format("{} ({})", family.statement.name, family.cases.size());
    if (group == groups.end())
      groups.push_back({family.statement.group, {name}});
    else
      group->second.push_back(name);
  }
  fmt::print("group: families (number of cases)\n");
  for (const auto& [group, names] : groups)
    fmt::print("{}:\n  {}\n", group, fmt::join(names, "\n  "));
  return 0;
}

int verify(const VerifyOptions& options) {
  options.style.check();
  const std::vector<verification::Family> families = verification::all_families();
  if (options.list) return list_names(families);
  std::vector<CaseRun> runs = from_usage([&] { return choose(families, options.selection); });
  if (!options.figures.empty()) {
    std::filesystem::create_directories(options.figures);
    const study::OutputFiles files(options.overwrite);
    for (const CaseRun& each : runs) files.check(figure_path(options, each));
  }
  const int threads = threads_or_all(options.threads);
  const bool in_full = !options.selection.names.empty() && !options.selection.seed;
  const bool text = !options.json && !options.markdown;
  run_all(runs, !options.selection.seed, threads, [&](const CaseRun& each) {
    fmt::print(text ? stdout : stderr, "{}", report::verification_text(each, in_full && text));
    std::fflush(text ? stdout : stderr);
  });
  if (!options.figures.empty()) write_figures(options, runs);
  if (options.json) fmt::print("{}", render::json(report::verification_facts(runs)));
  if (options.markdown) fmt::print("{}", report::verification_markdown(runs));
  if (text) fmt::print("{}", report::verification_summary(runs));
  return std::ranges::all_of(runs, [](const CaseRun& each) { return each.findings.passed(); })
             ? 0
             : kFailed;
}

struct ConvergeOptions {
  std::string job;
  FigureFile figure;
  study::UnitSystem units;
  std::size_t runs = 20;
  double tolerance_percent = 2;
  int threads = 0;
  bool json = false;
};

int converge_command(const ConvergeOptions& options) {
  const int threads = threads_or_all(options.threads);
  require_job(options.job, "converge");
  options.figure.check();
  const study::Convergence found =
      study::converge(study::convergence_cases(options.job, options.runs, threads),
                      0.01 * options.tolerance_percent, threads);
  print_findings(report::convergence_findings(found, options.units), options.json);
  options.figure.write([&] { return figures::convergence_figure(found); }, options.json);
  return found.failed.empty() ? 0 : 3;
}

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

struct CalibrateOptions {
  std::string trials, folder, base;
  NamedFigures figures;
  bool json = false, overwrite = false;
};

/// All of them or none.
void write_all(const CalibrateOptions& options, const calibration::Calibration& calibration,
               const std::vector<calibration::CasterFile>& casters, const std::string& text,
               const std::string& json) {
  const std::filesystem::path folder = options.folder;
  const NewFolder created(folder);
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

void add_verify(Commands& commands) {
  commands.add<VerifyOptions>(
      {"verify", "Verify the engine against closed-form solutions",
       "gurney verify\ngurney verify --list\ngurney verify skid_to_roll --draw 7 --count 3"},
      verify, [](Options& add, VerifyOptions& options) {
        add("NAME", options.selection.names,
            "Groups, families or cases to report in full (default: all)");
        add("--list", options.list, "Print the names of groups and families");
        add("--json", options.json, "Print JSON, with every check");
        add("--markdown", options.markdown, "Print docs/verification_tables.md");
        add("--figures FOLDER", options.figures,
            "Draw computed and reference of each case into this folder");
        add_figure_format(add, options.style);
        add("--overwrite", options.overwrite, "Replace figures that exist");
        CLI::Option* const draw =
            add("--draw", options.selection.seed,
                "Run parameters drawn in the ranges of each closed form with this seed");
        add("--count", options.selection.draws,
            "Number of consecutive seeds, starting with that of --draw (default: 1)")
            ->needs(draw)
            ->check(CLI::Range(1, 1000000));
        add.threads(options.threads, "Threads (default: all hardware threads)");
      });
}

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
        add_units_option(add, options.units, "m; of JSON si");
        add("--json", options.json, "Print JSON, in SI units or those of --units");
      });
}

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
