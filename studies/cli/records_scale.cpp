#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "engine/base/error.h"
#include "groundmotions/measures/combination.h"
#include "groundmotions/measures/response_spectrum.h"
#include "groundmotions/scaling/suite_scaling.h"
#include "groundmotions/scaling/target_spectrum.h"
#include "groundmotions/suites/list_suite.h"
#include "studies/cli/commands.h"
#include "studies/cli/output.h"
#include "studies/cli/process.h"
#include "studies/cli/record_source.h"
#include "studies/cli/shared_options.h"
#include "studies/cli/suite_options.h"
#include "studies/figures/record_figures.h"
#include "studies/results/output_files.h"

namespace gurney::cli {
namespace {

namespace fs = std::filesystem;

constexpr Eigen::Index kPeriods = 100;

struct ScaleOptions {
  RecordSource source;
  std::string target, periods = "0.1:2", component = "RotD50", mean = "arithmetic", output;
  FigureFile figure;
  std::string limits = "0.25:4";
  double floor_share = 0.9;
  bool common = false, overwrite = false, json = false;
};

groundmotions::TargetSpectrum target_of(const std::string& text) {
  return read_table_option("--target", text, "spectrum", "target",
                           [](config::Table& table) { return groundmotions::read_target(table); });
}

struct ScaledSuite {
  std::vector<groundmotions::SuiteRecord> records;
  std::vector<groundmotions::Record> motions;  ///< that have a spectrum of the component
};

/// A list that `gurney records` reads again, with the factors in it.
std::string list_text(const ScaledSuite& suite, const groundmotions::SuiteScaling& scaling,
                      const groundmotions::TargetSpectrum& target, const std::string& path) {
  std::vector<groundmotions::SuiteRecord> records = suite.records;
  for (std::size_t i = 0; i < records.size(); ++i)
    records[i].scale *= scaling.factors[static_cast<Eigen::Index>(i)];
  return groundmotions::list_suite_text(
      records, fs::absolute(path).parent_path(),
      fmt::format("scaled to {}, {:g} % damping", target.name, 100 * target.damping));
}

void print(const ScaleOptions& options, const ScaledSuite& suite,
           const groundmotions::SuiteScaling& scaling,
           const groundmotions::TargetSpectrum& target) {
  fmt::print("target {}\n{} spectra of {:g} % damping, {} s\n\n{:<32} {:>8} {:>8} {:>8}\n",
             target.name, options.component, 100 * target.damping, options.periods, "record", "own",
             "factor", "misfit");
  for (std::size_t i = 0; i < suite.records.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    fmt::print("{:<32} {:>8.3f} {:>8.3f} {:>8.3f}\n", suite.records[i].name,
               scaling.own_factors[row], scaling.factors[row], scaling.misfits[row]);
  }
  fmt::print(
      "\nfactor = own factor x {:.3f}, common to all; misfit of the mean {:.3f} (root mean square "
      "of ln)\n"
      "mean over target at least {:.3f}, at {:.3g} s\n",
      scaling.common_factor, scaling.suite_misfit, scaling.smallest_ratio,
      scaling.period_of_smallest);
  for (const std::string& warning : scaling.warnings) print_error("warning: {}\n", warning);
}

std::string json(const ScaledSuite& suite, const groundmotions::SuiteScaling& scaling,
                 const groundmotions::TargetSpectrum& target) {
  nlohmann::ordered_json records = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < suite.records.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    records.push_back({{"name", suite.records[i].name},
                       {"own_factor", scaling.own_factors[row]},
                       {"factor", scaling.factors[row]},
                       {"misfit", scaling.misfits[row]}});
  }
  const nlohmann::ordered_json result = {{"target", target.name},
                                         {"damping_ratio", target.damping},
                                         {"records", records},
                                         {"common_factor", scaling.common_factor},
                                         {"misfit_of_mean", scaling.suite_misfit},
                                         {"smallest_ratio", scaling.smallest_ratio},
                                         {"period_of_smallest_ratio_s", scaling.period_of_smallest},
                                         {"warnings", scaling.warnings}};
  return result.dump(2) + "\n";
}

int scale(const ScaleOptions& options) {
  options.figure.check(options.overwrite);
  require(options.output.empty() || options.source.steps.empty(),
          "--step with -o: a list of records has no place for steps, and the scaled suite would be "
          "without them; convert the records with the steps first (gurney records convert)");
  const groundmotions::TargetSpectrum target = target_of(options.target);
  const auto [low, high] = span_of("--periods", options.periods);
  const auto [smallest, largest] = span_of("--limits", options.limits);
  const groundmotions::Combination combination =
      groundmotions::parse_combination(options.component);
  const Eigen::VectorXd periods = groundmotions::logarithmic_periods(low, high, kPeriods);
  target.at(low), target.at(high);  // refuses a range that the target does not have

  ScaledSuite suite;
  const int code = for_each_record(
      options.source, nullptr,
      [&](const groundmotions::SuiteRecord& entry, const groundmotions::Record& record) {
        try {
          groundmotions::combined_spectrum(combination, record, periods.head(1), target.damping);
          suite.motions.push_back(record);
          suite.records.push_back(entry);
        } catch (const Error& error) {
          print_error("skipped: {}\n", error.what());
        }
      });
  require(!suite.records.empty(),
          "no record is left to scale; a record with one horizontal needs "
          "--component h1");
  std::vector<std::string> names;
  for (const groundmotions::SuiteRecord& record : suite.records) names.push_back(record.name);
  const auto spectra_at = [&](const Eigen::VectorXd& at) {
    Eigen::MatrixXd spectra(std::ssize(suite.motions), at.size());
    for (Eigen::Index i = 0; i < spectra.rows(); ++i)
      spectra.row(i) =
          groundmotions::combined_spectrum(combination, suite.motions[static_cast<std::size_t>(i)],
                                           at, target.damping)
              .transpose();
    return spectra;
  };
  groundmotions::SuiteScalingOptions how{smallest, largest, !options.common};
  how.mean = options.mean == "geometric" ? groundmotions::SuiteScalingOptions::Mean::kGeometric
                                         : groundmotions::SuiteScalingOptions::Mean::kArithmetic;
  how.floor_share = options.floor_share;
  const groundmotions::SuiteScaling scaling = groundmotions::scale_suite(
      periods, {spectra_at, [&](double period) { return target.at(period); }}, names, how);
  if (options.json)
    fmt::print("{}", json(suite, scaling, target));
  else
    print(options, suite, scaling, target);

  study::OutputFiles files(options.overwrite);
  if (!options.output.empty()) files.check(options.output);
  const SignalsHeld until_written;
  if (!options.output.empty())
    files.stage(options.output, list_text(suite, scaling, target, options.output));
  if (!options.figure.empty())
    files.stage(options.figure.path, options.figure.bytes(figures::suite_figure(
                                         target, periods, spectra_at(periods), scaling)));
  files.commit();
  return code;
}

}  // namespace

void add_records_scale(Commands& commands) {
  commands.add<ScaleOptions>(
      {"scale", "Factors that bring a suite of records to a target spectrum",
       "gurney records scale groundmotions/records --target \"asce7 sds_g=1 sd1_g=0.6\" \\\n"
       "  --periods 0.2:2 -o suite.csv"},
      scale, [](Options& add, ScaleOptions& options) {
        add_source_options(add, options.source);
        add.required(
            "--target", options.target,
            "Such as \"asce7 sds_g=1 sd1_g=0.6\", \"eurocode8 ground=B ag_g=0.3\", "
            "\"nzs1170 site_class=C hazard_factor=0.4\", \"ac156 sds_g=1 height_ratio=1\", "
            "\"table file=FILE.csv\" (docs/theory/scaling.md)");
        add("--periods LOW:HIGH", options.periods, "Period range of the fit, LOW:HIGH [s]");
        add("--component", options.component,
            "Spectrum of a record: RotD50, RotD100, geomean, larger, SRSS, h1, ...");
        add("--mean", options.mean, "Mean of the suite: arithmetic or geometric")
            ->check(CLI::IsMember({"arithmetic", "geometric"}));
        add("--floor-share", options.floor_share,
            "The mean is nowhere below this share of the target; 0: it meets the target "
            "on average")
            ->check(CLI::Range(0.0, 1.0));
        add("--factors,--limits LOW:HIGH", options.limits,
            "Factors allowed for a record, LOW:HIGH");
        add("--common", options.common, "One factor for all records");
        add("-o,--output FILE", options.output, "A list of the scaled suite to write (.csv)");
        add_figure_option(add, options.figure, "A figure to write");
        add("--json", options.json, "Print the factors as JSON");
        add("--overwrite", options.overwrite, "Replace files that exist");
      });
}

}  // namespace gurney::cli
