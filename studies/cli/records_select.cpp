#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <tuple>
#include <vector>

#include "engine/base/error.h"
#include "engine/base/files.h"
#include "engine/base/units.h"
#include "groundmotions/measures/combination.h"
#include "groundmotions/measures/response_spectrum.h"
#include "groundmotions/record/source_facts.h"
#include "groundmotions/selection/flatfile.h"
#include "groundmotions/selection/selection.h"
#include "groundmotions/selection/selection_target.h"
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
using groundmotions::Selection;
using groundmotions::SelectionTarget;
using groundmotions::SuiteRecord;

constexpr int kPeriods = 20;  // as Jayaram, Lin & Baker (2011)

struct SelectOptions {
  RecordSource source;
  std::string target, periods = "0.05:5", component = "RotD50", factors = "0.25:4", output;
  groundmotions::SelectionOptions selection;
  FigureFile figure;
  bool unscaled = false, overwrite = false, json = false;
};

/// Records to select from.
struct Pool {
  std::vector<SuiteRecord> records;
  groundmotions::Candidates candidates;
  std::string spectra;       ///< which, such as "RotD50 spectra"
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
    require(options_.source.steps.empty(),
            "--step: a flatfile has spectra of records as they are, which no step changes");
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
    const auto combination = groundmotions::parse_combination(options_.component);
    pool_.spectra = name_of(combination) + std::string(" spectra");
    pool_.code = for_each_record(
        options_.source, nullptr,
        [&](const SuiteRecord& entry, const groundmotions::Record& record) {
          try {
            const Eigen::VectorXd spectrum =
                groundmotions::combined_spectrum(combination, record, periods_, target_.damping);
            require(spectrum.minCoeff() > 0, entry.name + ": the spectrum is zero at a period");
            std::vector<groundmotions::NamedFacts> headers;
            for (const auto& component : record.components)
              if (component) headers.push_back(component->header);
            add(entry, headers, spectrum.array().log());
          } catch (const Error& error) {
            print_error("skipped: {}\n", error.what());
          }
        });
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

void print(const SelectionTarget& target, const Pool& pool, const Selection& selection) {
  fmt::print("target {}\n{} of {:g} % damping; {} records of {} selected\n\n{:<32} {:>8} {:>8}\n",
             target.name, pool.spectra, 100 * target.damping, selection.records.size(),
             pool.records.size(), "record", "factor", "misfit");
  for (std::size_t i = 0; i < selection.records.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    fmt::print("{:<32} {:>8.3f} {:>8.3f}\n",
               pool.records[static_cast<std::size_t>(selection.records[i])].name,
               selection.factors[row], selection.misfits[row]);
  }
  fmt::print("\n{:>8} {:>10} {:>7} {:>14} {:>14}\n", "T [s]", "median [g]", "sigma",
             "error of mean", "of sigma");
  const Eigen::VectorXd sigma = target.spectrum.sigma();
  for (Eigen::Index k = 0; k < sigma.size(); ++k)
    fmt::print("{:>8.3g} {:>10.4g} {:>7.3f} {:>14.3f} {:>14.3f}\n", target.spectrum.periods[k],
               std::exp(target.spectrum.mean[k]) / kStandardGravity, sigma[k],
               selection.errors.mean[k], selection.errors.sigma[k]);
  fmt::print(
      "{:>8} {:>10} {:>7} {:>14.3f} {:>14.3f}\n\nmisfit: root mean square of ln(Sa / median); "
      "errors: of mean and standard deviation of ln Sa\n",
      "rms", "", "", rms(selection.errors.mean), rms(selection.errors.sigma));
}

std::vector<double> numbers(const Eigen::VectorXd& values) {
  return {values.begin(), values.end()};
}

std::string json(const SelectOptions& options, const SelectionTarget& target, const Pool& pool,
                 const Selection& selection) {
  using Json = nlohmann::ordered_json;
  const auto text = [](const std::string& stated) {
    return stated.empty() ? Json() : Json(stated);
  };
  Json records = Json::array(), periods = Json::array();
  for (std::size_t i = 0; i < selection.records.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const auto j = static_cast<std::size_t>(selection.records[i]);
    records.push_back(
        {{"name", pool.records[j].name},
         {"event", text(pool.candidates.events[j])},
         {"station", text(pool.candidates.stations[j])},
         {"factor", selection.factors[row]},
         {"misfit", selection.misfits[row]},
         {"sa_m_per_s2", numbers(selection.ln_spectra.row(row).array().exp().transpose())}});
  }
  const Eigen::VectorXd sigma = target.spectrum.sigma();
  for (Eigen::Index k = 0; k < sigma.size(); ++k)
    periods.push_back({{"period_s", target.spectrum.periods[k]},
                       {"median_m_per_s2", std::exp(target.spectrum.mean[k])},
                       {"sigma", sigma[k]},
                       {"mean_error", selection.errors.mean[k]},
                       {"sigma_error", selection.errors.sigma[k]}});
  const Json result = {{"target", target.name},
                       {"damping_ratio", target.damping},
                       {"spectra", pool.spectra},
                       {"seed", options.selection.seed},
                       {"candidates", pool.records.size()},
                       {"excluded_by_usable_period", pool.unusable},
                       {"excluded_by_factor", selection.excluded},
                       {"records", records},
                       {"periods", periods},
                       {"total_error_of_nearest", selection.nearest_total},
                       {"total_error", selection.total}};
  return result.dump(2) + "\n";
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
  SelectOptions options = given;
  options.figure.check(options.overwrite);
  require(options.output.empty() || options.source.steps.empty(),
          "--step with -o: a list of records has no place for steps; convert the records with the "
          "steps first (gurney records convert)");
  const auto [low, high] = span_of("--periods", options.periods);
  std::tie(options.selection.smallest_factor, options.selection.largest_factor) =
      span_of("--factors", options.factors);
  options.selection.scaled = !options.unscaled;
  Eigen::VectorXd periods = groundmotions::logarithmic_periods(low, high, kPeriods);
  periods[0] = low, periods[kPeriods - 1] = high;  // without rounding: ends of tables
  const SelectionTarget target = read_table_option(
      "--target", options.target, "spectrum", "target",
      [&](config::Table& in) { return groundmotions::read_selection_target(in, periods); });
  study::OutputFiles files(options.overwrite);
  if (!options.output.empty()) files.check(options.output);

  const Pool pool = PoolReader(options, target).read();
  const Selection selection =
      groundmotions::select_records(target, pool.candidates, options.selection);
  const std::vector<SuiteRecord> records = selected_records(pool, selection);
  print_notes(options, pool, selection, records);
  if (options.json)
    fmt::print("{}", json(options, target, pool, selection));
  else
    print(target, pool, selection);

  const SignalsHeld until_written;
  if (!options.output.empty())
    files.stage(options.output,
                groundmotions::list_suite_text(
                    records, fs::absolute(options.output).parent_path(),
                    fmt::format("selected to {}, {:g} % damping, seed {}", target.name,
                                100 * target.damping, options.selection.seed)));
  if (!options.figure.empty())
    files.stage(options.figure.path,
                options.figure.bytes(figures::selection_figure(target, selection)));
  files.commit();
  return pool.code;
}

}  // namespace

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
        add("--factors LOW:HIGH", options.factors, "Factors allowed for a record, LOW:HIGH");
        add("--unscaled", options.unscaled, "Select records as they are, with the factor 1");
        add("--per-event", options.selection.per_event,
            "Largest number of records of one event; 0: any number")
            ->check(CLI::NonNegativeNumber);
        add("--per-station", options.selection.per_station,
            "Largest number of records of one station; 0: any number")
            ->check(CLI::NonNegativeNumber);
        add("--seed", options.selection.seed, "Seed of the simulated spectra");
        add("-o,--output FILE", options.output, "A list of the selected suite to write (.csv)");
        add_figure_option(add, options.figure, "A figure to write");
        add("--json", options.json, "Print the selection as JSON");
        add("--overwrite", options.overwrite, "Replace files that exist");
      });
}

}  // namespace gurney::cli
