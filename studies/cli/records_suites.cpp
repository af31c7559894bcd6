#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <memory>
#include <tuple>
#include <vector>

#include "engine/base/error.h"
#include "engine/base/files.h"
#include "engine/base/names.h"
#include "engine/base/number_text.h"
#include "engine/base/units.h"
#include "groundmotions/measures/combination.h"
#include "groundmotions/measures/response_spectrum.h"
#include "groundmotions/record/source_facts.h"
#include "groundmotions/scaling/suite_scaling.h"
#include "groundmotions/scaling/target_spectrum.h"
#include "groundmotions/selection/flatfile.h"
#include "groundmotions/selection/selection.h"
#include "groundmotions/selection/selection_target.h"
#include "groundmotions/suites/list_suite.h"
#include "studies/cli/commands.h"
#include "studies/cli/inline_table.h"
#include "studies/cli/output.h"
#include "studies/cli/process.h"
#include "studies/cli/record_source.h"
#include "studies/cli/shared_options.h"
#include "studies/figures/record_figures.h"
#include "studies/report/formats.h"
#include "studies/results/output_files.h"

namespace gurney::cli {
namespace {

namespace fs = std::filesystem;

using groundmotions::Selection;
using groundmotions::SelectionTarget;
using groundmotions::SuiteRecord;

/// What both commands are asked, and the files that they write.
struct SuiteOptions {
  RecordSource source;
  std::string target, periods, factors = "0.25:4", output;
  std::string component = {};  ///< empty: RotD50
  FigureFile figure;
  bool json = false;
};

struct ScaleOptions : SuiteOptions {
  ScaleOptions() { periods = "0.1:2"; }
  std::string mean = "arithmetic";
  double floor_share = 0.9;
  bool common = false;
};

/// To be called before anything is computed.
void check_outputs(const SuiteOptions& options) {
  options.figure.check();
  if (!options.output.empty()) check_csv_output(options.output, options.figure.overwrite);
}

groundmotions::Combination combination_of(const SuiteOptions& options) {
  return options.component.empty() ? groundmotions::Combination::kRotD50
                                   : groundmotions::parse_combination(options.component);
}

/// @param list  text of the list of -o; @param figure  SVG
void write_files(const SuiteOptions& options, const std::function<std::string()>& list,
                 const std::function<std::string()>& figure) {
  study::OutputFiles files(options.figure.overwrite);
  if (!options.output.empty()) files.check(options.output);
  const SignalsHeld until_written;
  if (!options.output.empty()) files.stage(options.output, list());
  if (!options.figure.empty()) files.stage(options.figure.path, options.figure.bytes(figure()));
  files.commit();
}

std::string list_text(const SuiteOptions& options, const std::vector<SuiteRecord>& records,
                      const std::string& title) {
  return groundmotions::list_suite_text(records, fs::absolute(options.output).parent_path(), title);
}

void add_figure_and_list(Options& add, SuiteOptions& options, const char* list) {
  add("-o,--output FILE", options.output, list);
  add_figure_option(add, options.figure, "A figure to write", "--figure FILE", "files that exist");
}

const findings::Format kThree{".3f"};

/// Two numbers apart by a colon, 0 < low < high. @throws Error for anything else.
std::pair<double, double> span_of(const char* option, const std::string& text) {
  const auto colon = std::min(text.find(':'), text.size());
  const double low = number(text.substr(0, colon)).value_or(0);
  const double high = number(text.substr(std::min(colon + 1, text.size()))).value_or(0);
  require(0 < low && low < high,
          fmt::format("{} {}: must be LOW:HIGH with 0 < LOW < HIGH", option, text));
  return {low, high};
}

/// The spectrum that --target states. @param read  its table -> optional, empty: it noted an error
template <class Read>
auto target_of(const std::string& text, const Read& read) {
  return *read_option("--target", text, "spectrum", "target", [&](config::Table& root) {
    auto table = root.table("spectrum");
    return table ? read(*table) : std::nullopt;
  });
}

struct ScaledSuite {
  std::vector<groundmotions::SuiteRecord> records;
  std::vector<groundmotions::Record> motions;  ///< that have a spectrum of the component
};

findings::Section scaling_findings(const ScaleOptions& options, const ScaledSuite& suite,
                                   const groundmotions::SuiteScaling& scaling,
                                   const groundmotions::TargetSpectrum& target) {
  findings::Section all{"", "target " + target.name};
  all.json("target", target.name).json("damping_ratio", target.damping);
  all.say(fmt::format("{} spectra of {:g} % damping, {} s", name_of(combination_of(options)),
                      100 * target.damping, options.periods));
  findings::Table records{"records", "", {}};
  for (std::size_t i = 0; i < suite.records.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    report::add_row(records, {{{"name", "record"}, suite.records[i].name},
                              {{"own_factor", "own", kThree}, scaling.own_factors[row]},
                              {{"factor", "factor", kThree}, scaling.factors[row]},
                              {{"misfit", "misfit", kThree}, scaling.misfits[row]}});
  }
  all.add(std::move(records)).json("common_factor", scaling.common_factor);
  all.json("misfit_of_mean", scaling.suite_misfit).json("smallest_ratio", scaling.smallest_ratio);
  all.json("period_of_smallest_ratio_s", scaling.period_of_smallest);
  all.list("warnings", "", scaling.warnings);
  all.say(fmt::format(
      "factor = own factor x {:.3f}, common to all; misfit of the mean {:.3f} (root mean square "
      "of ln)",
      scaling.common_factor, scaling.suite_misfit));
  return all.say(fmt::format("mean over target at least {:.3f}, at {:.3g} s",
                             scaling.smallest_ratio, scaling.period_of_smallest));
}

int scale(const ScaleOptions& options) {
  constexpr Eigen::Index kPeriods = 100;
  check_outputs(options);
  require(options.output.empty() || options.source.steps.empty(),
          "--step with -o: a list of records has no place for steps, and the scaled suite would be "
          "without them; convert the records with the steps first (gurney records convert)");
  const groundmotions::TargetSpectrum target =
      target_of(options.target, [](config::Table& in) { return groundmotions::read_target(in); });
  const auto [low, high] = span_of("--periods", options.periods);
  const auto [smallest, largest] = span_of("--factors", options.factors);
  const groundmotions::Combination combination = combination_of(options);
  const Eigen::VectorXd periods = groundmotions::logarithmic_periods(low, high, kPeriods);
  target.at(low), target.at(high);  // refuses a range that the target does not have

  ScaledSuite suite;
  ShortPeriods coarse(low);
  const int code = for_each_record(
      options.source, nullptr,
      [&](const groundmotions::SuiteRecord& entry, const groundmotions::Record& record) {
        try {
          groundmotions::combined_spectrum(combination, record, periods.head(1), target.damping);
          coarse.take(record);
          suite.motions.push_back(record);
          suite.records.push_back(entry);
        } catch (const Error& error) {
          print_error("skipped: {}\n", error.what());
        }
      });
  require(!suite.records.empty(),
          "no record is left to scale; a record with one horizontal needs "
          "--component h1");
  const std::vector<std::string> names = names_of(suite.records);
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
  groundmotions::SuiteScaling scaling = groundmotions::scale_suite(
      periods, {spectra_at, [&](double period) { return target.at(period); }}, names, how);
  if (!coarse.warning().empty()) scaling.warnings.push_back(coarse.warning());
  print_findings(scaling_findings(options, suite, scaling, target), options.json);
  for (const std::string& warning : scaling.warnings)
    if (!options.json) print_error("warning: {}\n", warning);
  for (std::size_t i = 0; i < suite.records.size(); ++i)
    suite.records[i].scale *= scaling.factors[static_cast<Eigen::Index>(i)];
  write_files(
      options,
      [&] {
        return list_text(
            options, suite.records,
            fmt::format("scaled to {}, {:g} % damping", target.name, 100 * target.damping));
      },
      [&] { return figures::suite_figure(target, periods, spectra_at(periods), scaling); });
  return code;
}

struct SelectOptions : SuiteOptions {
  SelectOptions() { periods = "0.05:5"; }
  groundmotions::SelectionOptions selection;
  bool unscaled = false;
};

/// Records to select from.
struct Pool {
  std::vector<SuiteRecord> records;
  groundmotions::Candidates candidates;
  std::string spectra;       ///< which, such as "RotD50 spectra"
  std::string warning;       ///< of records whose samples are too far apart; may be empty
  std::size_t unusable = 0;  ///< excluded: not usable up to the longest period
  int code = 0;
};

class PoolReader {
 public:
  PoolReader(const SelectOptions& options, const SelectionTarget& target)
      : options_(options), target_(target), periods_(target.spectrum.periods) {}

  Pool read() {
    if (const auto file = flatfile())
      read_flatfile(*file);
    else
      read_records();
    pool_.candidates.ln_spectra.resize(std::ssize(spectra_), periods_.size());
    for (std::size_t i = 0; i < spectra_.size(); ++i)
      pool_.candidates.ln_spectra.row(static_cast<Eigen::Index>(i)) = spectra_[i];
    return std::move(pool_);
  }

 private:
  /// The only path, if it is a flatfile; else null.
  std::unique_ptr<const groundmotions::SourceFile> flatfile() const {
    if (options_.source.paths.size() != 1 || !is_file(options_.source.paths[0])) return {};
    try {
      auto file = std::make_unique<const groundmotions::SourceFile>(options_.source.paths[0]);
      if (groundmotions::recognises_flatfile(*file)) return file;
    } catch (const Error&) {
      // reported when it is read as a record
    }
    return {};
  }

  void read_flatfile(const groundmotions::SourceFile& file) {
    const groundmotions::ReadOptions& options = options_.source.options;
    for (const auto& [option, given] : {std::pair("--component", !options_.component.empty()),
                                        {"--unit", !options.unit.empty()},
                                        {"--time-step", options.time_step.has_value()},
                                        {"--count", options.si_per_count.has_value()},
                                        {"--columns", !options.columns.empty()},
                                        {"--step", !options_.source.steps.empty()}})
      require(!given,
              std::string(option) +
                  ": has no effect: a flatfile has spectra, those of the records as they are");
    require(target_.damping == 0.05,
            fmt::format("--target: the damping is {:g} %, that of a flatfile's spectra is 5 %",
                        100 * target_.damping));
    const groundmotions::Flatfile flatfile = groundmotions::read_flatfile(file, periods_);
    pool_.spectra = "spectra of the flatfile";
    for (std::size_t i = 0; i < flatfile.suite.records.size(); ++i)
      add(flatfile.suite.records[i], {},
          flatfile.ln_spectra.row(static_cast<Eigen::Index>(i)).transpose());
    for (const std::string& note : flatfile.suite.notes) print_error("note: {}\n", note);
  }

  void read_records() {
    const auto combination = combination_of(options_);
    ShortPeriods coarse(periods_[0]);
    pool_.spectra = name_of(combination) + std::string(" spectra");
    pool_.code = for_each_record(
        options_.source, nullptr,
        [&](const SuiteRecord& entry, const groundmotions::Record& record) {
          try {
            const Eigen::VectorXd spectrum =
                groundmotions::combined_spectrum(combination, record, periods_, target_.damping);
            coarse.take(record);
            require(spectrum.minCoeff() > 0, entry.name + ": the spectrum is zero at a period");
            std::vector<groundmotions::NamedFacts> headers;
            for (const auto& component : record.components)
              if (component) headers.push_back(component->header);
            add(entry, headers, spectrum.array().log());
          } catch (const Error& error) {
            print_error("skipped: {}\n", error.what());
          }
        });
    pool_.warning = coarse.warning();
  }

  void add(const SuiteRecord& record, std::vector<groundmotions::NamedFacts> headers,
           const Eigen::VectorXd& ln_spectrum) {
    headers.insert(headers.begin(), record.facts);
    const groundmotions::SourceFacts facts = groundmotions::source_facts(headers);
    if (facts.lowest_frequency * periods_[periods_.size() - 1] > 1) {  // false where not stated
      ++pool_.unusable;
      return;
    }
    pool_.records.push_back(record);
    pool_.candidates.events.push_back(facts.event);
    pool_.candidates.stations.push_back(facts.station);
    spectra_.push_back(ln_spectrum);
  }

  const SelectOptions& options_;
  const SelectionTarget& target_;
  const Eigen::VectorXd& periods_;
  std::vector<Eigen::VectorXd> spectra_;
  Pool pool_;
};

/// The selected records with their factors, as a list has them.
std::vector<SuiteRecord> selected_records(const Pool& pool, const Selection& selection) {
  std::vector<SuiteRecord> records;
  for (const Eigen::Index j : selection.records) {
    records.push_back(pool.records[static_cast<std::size_t>(j)]);
    records.back().scale *= selection.factors[std::ssize(records) - 1];
  }
  return records;
}

double rms(const Eigen::VectorXd& values) {
  return values.norm() / std::sqrt(static_cast<double>(values.size()));
}

findings::Section selection_findings(const SelectOptions& options, const SelectionTarget& target,
                                     const Pool& pool, const Selection& selection) {
  const auto stated = [](const std::string& text) {
    return text.empty() ? findings::Value() : findings::Value(text);
  };
  findings::Section all{"", "target " + target.name};
  all.json("target", target.name).json("damping_ratio", target.damping);
  all.json("spectra", pool.spectra).json("seed", options.selection.seed);
  all.json("candidates", pool.records.size()).json("excluded_by_usable_period", pool.unusable);
  all.json("excluded_by_factor", selection.excluded);
  all.say(fmt::format("{} of {:g} % damping; {} records of {} selected", pool.spectra,
                      100 * target.damping, selection.records.size(), pool.records.size()));
  findings::Table records{"records", "", {}};
  for (std::size_t i = 0; i < selection.records.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const auto j = static_cast<std::size_t>(selection.records[i]);
    const Eigen::VectorXd spectrum = selection.ln_spectra.row(row).array().exp().transpose();
    report::add_row(records, {{{"name", "record"}, pool.records[j].name},
                              {"event", stated(pool.candidates.events[j])},
                              {"station", stated(pool.candidates.stations[j])},
                              {{"factor", "factor", kThree}, selection.factors[row]},
                              {{"misfit", "misfit", kThree}, selection.misfits[row]},
                              {"sa_m_per_s2", spectrum}});
  }
  findings::Table periods{"periods", "", {}};
  const Eigen::VectorXd sigma = target.spectrum.sigma();
  for (Eigen::Index k = 0; k < sigma.size(); ++k)
    report::add_row(periods, {{{"period_s", "T", {".3g", "s"}}, target.spectrum.periods[k]},
                              {{"median_m_per_s2", "median", {".4g", "g", kStandardGravity}},
                               std::exp(target.spectrum.mean[k])},
                              {{"sigma", "sigma", kThree}, sigma[k]},
                              {{"mean_error", "error of mean", kThree}, selection.errors.mean[k]},
                              {{"sigma_error", "of sigma", kThree}, selection.errors.sigma[k]}});
  all.add(std::move(records)).add(std::move(periods));
  all.json("total_error_of_nearest", selection.nearest_total).json("total_error", selection.total);
  return all.say(fmt::format(
      "misfit: root mean square of ln(Sa / median); errors: of mean and standard deviation of ln "
      "Sa, their root mean squares {:.3f} and {:.3f}",
      rms(selection.errors.mean), rms(selection.errors.sigma)));
}

void print_notes(const SelectOptions& options, const Pool& pool, const Selection& selection,
                 const std::vector<SuiteRecord>& records) {
  if (pool.unusable > 0)
    print_error("note: {} records are excluded: not usable up to the longest period\n",
                pool.unusable);
  if (selection.excluded > 0)
    print_error("note: {} records are excluded: their factor is not in {}\n", selection.excluded,
                options.factors);
  const auto unknown = [&](const std::vector<std::string>& groups, int limit, const char* option) {
    const auto count = std::ranges::count(groups, "");
    if (limit > 0 && count > 0)
      print_error("warning: {}: {} of {} records do not state theirs and are not limited\n", option,
                  count, groups.size());
  };
  if (!pool.warning.empty()) print_error("warning: {}\n", pool.warning);
  unknown(pool.candidates.events, options.selection.per_event, "--per-event");
  unknown(pool.candidates.stations, options.selection.per_station, "--per-station");
  const auto absent = std::ranges::count_if(records, [](const SuiteRecord& record) {
    return !std::ranges::all_of(
        record.files, [](const groundmotions::RecordFile& file) { return is_file(file.path); });
  });
  if (absent > 0)
    print_error("note: the files of {} selected records are not in the folder of the flatfile\n",
                absent);
}

int select(const SelectOptions& given) {
  constexpr int kPeriods = 20;  // as Jayaram, Lin & Baker (2011)
  SelectOptions options = given;
  check_outputs(options);
  require(options.output.empty() || options.source.steps.empty(),
          "--step with -o: a list of records has no place for steps; convert the records with the "
          "steps first (gurney records convert)");
  const auto [low, high] = span_of("--periods", options.periods);
  std::tie(options.selection.smallest_factor, options.selection.largest_factor) =
      span_of("--factors", options.factors);
  options.selection.scaled = !options.unscaled;
  Eigen::VectorXd periods = groundmotions::logarithmic_periods(low, high, kPeriods);
  periods[0] = low, periods[kPeriods - 1] = high;  // without rounding: ends of tables
  const SelectionTarget target = target_of(options.target, [&](config::Table& in) {
    return groundmotions::read_selection_target(in, periods);
  });
  const Pool pool = PoolReader(options, target).read();
  const Selection selection =
      groundmotions::select_records(target, pool.candidates, options.selection);
  const std::vector<SuiteRecord> records = selected_records(pool, selection);
  print_notes(options, pool, selection, records);
  print_findings(selection_findings(options, target, pool, selection), options.json);
  write_files(
      options,
      [&] {
        return list_text(options, records,
                         fmt::format("selected to {}, {:g} % damping, seed {}", target.name,
                                     100 * target.damping, options.selection.seed));
      },
      [&] { return figures::selection_figure(target, selection); });
  return pool.code;
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
            ->check(Options::one_of({"arithmetic", "geometric"}));
        add("--floor-share", options.floor_share,
            "The mean is nowhere below this share of the target; 0: it meets the target "
            "on average")
            ->check(CLI::Range(0.0, 1.0));
        add("--factors,--limits LOW:HIGH", options.factors,
            "Factors allowed for a record, LOW:HIGH");
        add("--common", options.common, "One factor for all records");
        add_figure_and_list(add, options, "A list of the scaled suite to write (.csv)");
        add("--json", options.json, "Print the factors as JSON");
      });
}

void add_records_select(Commands& commands) {
  commands.add<SelectOptions>(
      {"select", "Select records whose spectra match a target's mean and variance",
       "gurney records select PEER_download --target \"conditional magnitude=7 distance_km=10 \\\n"
       "  vs30_m_per_s=400 period_s=1 epsilon=1.5\" --records 20 --per-event 3 -o suite.csv\n"
       "gurney records select FLATFILE.csv \\\n"
       "  --target \"openquake file=cs.csv poe=0.02 period_s=1\" -o suite.csv"},
      select, [](Options& add, SelectOptions& options) {
        add_source_options(add, options.source);
        add.required("--target", options.target,
                     "Such as \"bssa14 magnitude=7 distance_km=10\", \"conditional ... period_s=1 "
                     "epsilon=1.5\" (or sa_g=0.5), \"table file=FILE.csv\", \"openquake "
                     "file=FILE.csv poe=0.02\", or as of records scale "
                     "(docs/theory/selection.md)");
        add("-n,--records", options.selection.count, "Number of records to select");
        add("--periods LOW:HIGH", options.periods, "Period range of the comparison, LOW:HIGH [s]");
        add("--component", options.component,
            "Spectrum of a record: RotD50, RotD100, geomean, larger, SRSS, h1, ...");
        CLI::Option* const factors =
            add("--factors LOW:HIGH", options.factors, "Factors allowed for a record, LOW:HIGH");
        add("--unscaled", options.unscaled, "Select records as they are, with the factor 1")
            ->excludes(factors);
        add("--per-event", options.selection.per_event,
            "Largest number of records of one event; 0: any number")
            ->check(Options::not_negative());
        add("--per-station", options.selection.per_station,
            "Largest number of records of one station; 0: any number")
            ->check(Options::not_negative());
        add("--seed", options.selection.seed, "Seed of the simulated spectra");
        add_figure_and_list(add, options, "A list of the selected suite to write (.csv)");
        add("--json", options.json, "Print the selection as JSON");
      });
}

}  // namespace gurney::cli
