#include "studies/analysis/study_comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <set>

#include "engine/base/error.h"
#include "engine/config/document.h"
#include "engine/config/overlay.h"
#include "engine/response/response.h"
#include "studies/analysis/demands.h"
#include "studies/job/old_names.h"
#include "studies/plan/study_job.h"
#include "studies/statistics/quantiles.h"
#include "studies/statistics/two_groups.h"

namespace gurney::study {
namespace {

using config::Node;
using Entries = std::map<std::string, std::string>;

/// The job of one configuration, with [study] but without its factors.
Entries job_of(const ConfigurationView& side) {
  const StudyReader& file = side.data->file();
  config::Document document(file.job_text(), file.path());
  rename_old_keys(document);
  Entries entries;
  auto study = document.take("study");
  std::erase_if(study->elements, [](const Node& each) { return each.key == "factor"; });
  flatten(*study, "study", entries);
  Node job = document.tree();
  for (const Factor& factor : side.data->study().factors) {
    const std::string level = file.strings("configurations/" + factor.name)[side.configuration];
    for (const FactorLevel& each : factor.levels)
      if (each.name == level) config::overlay(job, each.patch, factor.name, document);
  }
  flatten(job, "", entries);
  return entries;
}

Entries assumptions_of(const ConfigurationView& side) {
  const StudyReader& file = side.data->file();
  const auto configuration = file.strings("assumptions/configuration");
  const auto keys = file.strings("assumptions/key"), values = file.strings("assumptions/value"),
             ranges = file.strings("assumptions/range");
  Entries entries;
  for (std::size_t row = 0; row < keys.size(); ++row)
    if (configuration[row] == std::to_string(side.configuration))
      entries[keys[row]] = fmt::format("{} ({})", values[row], ranges[row]);
  return entries;
}

Entries data_files_of(const ConfigurationView& side) {
  const StudyReader& file = side.data->file();
  const auto names = file.strings("data_files/name"), hashes = file.strings("data_files/sha256");
  Entries entries;
  for (std::size_t row = 0; row < names.size(); ++row) entries[names[row]] = hashes[row];
  return entries;
}

Entries program_of(const ConfigurationView& side) {
  Entries entries;
  for (const char* name :
       {"program_version", "git_commit", "compiler", "bullet_precision", "cpu_class"})
    entries[name] = side.data->file().text_attribute(name);
  return entries;
}

/// Name of each record with what it came from.
Entries records_of(const ConfigurationView& side) {
  const StudyReader& file = side.data->file();
  const auto files = file.strings("records/files"), processing = file.strings("records/processing");
  const std::vector<std::string> names = record_names(side);
  const std::vector<std::size_t> rows = record_rows(side);
  Entries entries;
  for (std::size_t i = 0; i < rows.size(); ++i)
    entries[names[i]] = files[rows[i]] + "\n" + processing[rows[i]];
  return entries;
}

std::vector<InputDifference> differences(const Entries& a, const Entries& b) {
  std::vector<InputDifference> result;
  Entries all = a;
  all.insert(b.begin(), b.end());
  for (const auto& [key, ignored] : all) {
    const auto in_a = a.find(key), in_b = b.find(key);
    const InputDifference each{key, in_a == a.end() ? "" : in_a->second,
                               in_b == b.end() ? "" : in_b->second};
    if (each.a != each.b) result.push_back(each);
  }
  return result;
}

}  // namespace

bool InputDifferences::empty() const {
  return job.empty() && assumptions.empty() && data_files.empty() && program.empty() &&
         records_of_a.empty() && records_of_b.empty() && records_changed.empty();
}

InputDifferences input_differences(const ConfigurationView& a, const ConfigurationView& b) {
  InputDifferences result;
  result.job = differences(job_of(a), job_of(b));
  result.assumptions = differences(assumptions_of(a), assumptions_of(b));
  result.data_files = differences(data_files_of(a), data_files_of(b));
  result.program = differences(program_of(a), program_of(b));
  const Entries of_a = records_of(a), of_b = records_of(b);
  for (const auto& [name, source] : of_a) {
    const auto other = of_b.find(name);
    if (other == of_b.end()) {
      result.records_of_a.push_back(name);
      continue;
    }
    ++result.records_common;
    if (other->second != source) result.records_changed.push_back(name);
  }
  for (const auto& [name, source] : of_b)
    if (!of_a.contains(name)) result.records_of_b.push_back(name);
  return result;
}

namespace {

/// Key that makes runs of two files the same, as text: numbers are rounded there.
struct RunKey {
  std::size_t run;
  std::string record, level, angle, draw;
};

std::string rounded(double value) { return fmt::format("{:.9g}", value + 0.0); }

std::string intensity_of(const StudyData& data) {
  return data.file().text_attribute("intensity_measure");
}

/// A Latin hypercube of another size is another plan.
std::size_t size_of_plan(const StudyData& data) {
  if (data.study().sampling == Sampling::kMonteCarlo) return 0;
  std::map<std::string, std::size_t> records;
  std::size_t most = 0;
  for (const std::string& set : data.file().strings("records/set"))
    most = std::max(most, ++records[set]);
  return most;
}

/// Whether a draw of a number is the same draw in both.
bool same_draws(const StudyData& a, const StudyData& b) {
  const Study &of_a = a.study(), &of_b = b.study();
  return of_a.draws > 0 && of_a.draws == of_b.draws && of_a.seed == of_b.seed &&
         of_a.sampling == of_b.sampling && size_of_plan(a) == size_of_plan(b);
}

std::vector<RunKey> keys_of(const ConfigurationView& side, bool by_intensity) {
  const StudyReader& file = side.data->file();
  const std::vector<double> level = file.numbers(by_intensity ? "runs/intensity" : "runs/scale");
  const std::vector<double> angle = file.numbers("runs/angle"), draw = file.numbers("runs/draw");
  const std::vector<std::string> records = record_names(side);
  std::vector<RunKey> keys;
  for (const std::size_t run : side.runs())
    keys.push_back({run, records.at(side.data->record_of(run)), rounded(level[run]),
                    rounded(angle[run]), rounded(draw[run])});
  return keys;
}

std::set<std::string> values_of_key(const std::vector<RunKey>& keys, std::string RunKey::*part) {
  std::set<std::string> values;
  for (const RunKey& key : keys) values.insert(key.*part);
  return values;
}

std::set<std::string> common_values(const std::vector<RunKey>& a, const std::vector<RunKey>& b,
                                    std::string RunKey::*part) {
  const std::set<std::string> of_a = values_of_key(a, part), of_b = values_of_key(b, part);
  std::set<std::string> both;
  std::ranges::set_intersection(of_a, of_b, std::inserter(both, both.end()));
  return both;
}

void require_common(const std::set<std::string>& common, const char* what,
                    const ConfigurationView& a, const ConfigurationView& b) {
  require(!common.empty(),
          fmt::format("{} '{}' and {} '{}' have no {} in common: nothing can be compared with each "
                      "other",
                      a.data->file().path(), a.configuration_name(), b.data->file().path(),
                      b.configuration_name(), what));
}

}  // namespace

RunPairs pair_runs(const ConfigurationView& a, const ConfigurationView& b) {
  RunPairs result;
  const std::string measure = intensity_of(*a.data);
  result.by_intensity = !measure.empty() && measure == intensity_of(*b.data);
  result.level = result.by_intensity ? measure : "scale";
  const std::array<std::vector<RunKey>, 2> keys{keys_of(a, result.by_intensity),
                                                keys_of(b, result.by_intensity)};
  const auto records = common_values(keys[0], keys[1], &RunKey::record);
  require_common(records, "record", a, b);
  require_common(common_values(keys[0], keys[1], &RunKey::level), "level", a, b);
  result.by_angle = !common_values(keys[0], keys[1], &RunKey::angle).empty();
  result.by_draw = same_draws(*a.data, *b.data);
  result.group = records.size() > 1 ? RunPairs::Group::kRecord
                 : result.by_draw   ? RunPairs::Group::kDraw
                                    : RunPairs::Group::kNone;

  std::map<std::string, std::size_t> groups;
  const auto group_of = [&](const RunKey& key) {
    const bool of_draw = result.group == RunPairs::Group::kDraw;
    return groups.try_emplace(of_draw ? key.draw : key.record, groups.size()).first->second;
  };
  std::map<std::array<std::string, 4>, std::array<std::vector<std::size_t>, 2>> together;
  std::map<std::array<std::string, 4>, std::size_t> group_of_pair;
  for (const std::size_t side : {0, 1})
    for (const RunKey& key : keys[side]) {
      if (!records.contains(key.record)) continue;
      (side == 0 ? result.common_a : result.common_b).emplace_back(key.run, group_of(key));
      const std::array<std::string, 4> common{
          key.record, key.level, result.by_angle ? key.angle : "", result.by_draw ? key.draw : ""};
      together[common][side].push_back(key.run);
      group_of_pair[common] = group_of(key);
    }
  std::set<std::size_t> paired;
  for (const auto& [common, runs] : together) {
    if (runs[0].empty() || runs[1].empty()) continue;
    result.pairs.push_back({runs[0], runs[1], group_of_pair[common]});
    paired.insert(group_of_pair[common]);
    result.paired_a += runs[0].size();
    result.paired_b += runs[1].size();
  }
  require(!result.pairs.empty(),
          fmt::format("{} and {}: no run of one had the same record, level, angle and draw as one "
                      "of the other",
                      a.data->file().path(), b.data->file().path()));
  result.groups = paired.size();
  result.left_out_a = a.runs().size() - result.paired_a;
  result.left_out_b = b.runs().size() - result.paired_b;
  return result;
}

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// A number for each run of a side.
using RunValues = std::map<std::size_t, double>;

std::vector<std::size_t> runs_in(const std::vector<std::pair<std::size_t, std::size_t>>& common) {
  std::vector<std::size_t> runs;
  for (const auto& [run, group] : common) runs.push_back(run);
  return runs;
}

template <class Numbers>
RunValues by_run(const std::vector<std::size_t>& runs, const Numbers& numbers) {
  RunValues values;
  for (std::size_t i = 0; i < runs.size(); ++i) values[runs[i]] = numbers[i];
  return values;
}

/// Mean over runs of one pair; NaN where one of them has no number.
double mean_over(const std::vector<std::size_t>& runs, const RunValues& values) {
  double sum = 0;
  for (const std::size_t run : runs) sum += values.at(run);
  return sum / static_cast<double>(runs.size());
}

class Comparer {
 public:
  Comparer(const ConfigurationView& a, const ConfigurationView& b, const ComparisonOptions& options)
      : a_(a), b_(b), options_(options) {
    result_.pairs = pair_runs(a, b);
    runs_a_ = runs_in(result_.pairs.common_a);
    runs_b_ = runs_in(result_.pairs.common_b);
  }

  StudyComparison compare() {
    count_overturned();
    choose_measure();
    compare_states();
    compare_demands();
    adjust();
    return result_;
  }

 private:
  bool nothing_random() const { return result_.pairs.group == RunPairs::Group::kNone; }

  /// @returns false where no pair has a number on both sides
  bool add(ComparedQuantity::Kind kind, const std::string& name, const std::string& units,
           const RunValues& of_a, const RunValues& of_b);
  void add_curves(std::size_t state, const RunValues& of_a, const RunValues& of_b);
  void choose_measure();
  void compare_states();
  void compare_demands();
  void count_overturned();
  void adjust();

  ConfigurationView a_, b_;
  const ComparisonOptions& options_;
  StudyComparison result_;
  std::vector<std::size_t> runs_a_, runs_b_;
  RunMeasure im_a_, im_b_;
};

bool Comparer::add(ComparedQuantity::Kind kind, const std::string& name, const std::string& units,
                   const RunValues& of_a, const RunValues& of_b) {
  std::vector<statistics::Measured> measured_a, measured_b;
  std::map<std::size_t, int> pairs_of_group;
  bool one_each = true;
  for (const RunPairs::Pair& pair : result_.pairs.pairs) {
    const double value_a = mean_over(pair.a, of_a), value_b = mean_over(pair.b, of_b);
    if (std::isnan(value_a) || std::isnan(value_b)) continue;
    measured_a.push_back({value_a, pair.group});
    measured_b.push_back({value_b, pair.group});
    if (++pairs_of_group[pair.group] > 1) one_each = false;
  }
  if (measured_a.empty()) return false;
  const statistics::PairedDifference paired =
      statistics::paired_difference(measured_a, measured_b, options_.confidence, options_.seed);
  ComparedQuantity row;
  row.kind = kind;
  row.name = name;
  row.units = units;
  row.groups = static_cast<std::size_t>(paired.pairs);
  if (kind == ComparedQuantity::Kind::kMedian) {
    std::map<std::size_t, std::pair<double, double>> sums;
    for (std::size_t i = 0; i < measured_a.size(); ++i) {
      sums[measured_a[i].group].first += measured_a[i].value;
      sums[measured_a[i].group].second += measured_b[i].value;
    }
    std::vector<double> values_a, values_b, differences;
    for (const auto& [group, sum] : sums) {
      values_a.push_back(sum.first / pairs_of_group[group]);
      values_b.push_back(sum.second / pairs_of_group[group]);
      differences.push_back(values_b.back() - values_a.back());
    }
    const statistics::MedianInterval median =
        statistics::median_interval(differences, options_.confidence);
    row.a = statistics::quantile_of(values_a, 0.5);
    row.b = statistics::quantile_of(values_b, 0.5);
    row.difference = median.median;
    row.interval = median.interval;
    row.p = paired.p_sign;
  } else {
    row.a = paired.mean_a;
    row.b = paired.mean_b;
    row.difference = paired.difference;
    row.interval = paired.interval;
    if (kind == ComparedQuantity::Kind::kShare && std::isfinite(row.interval.low))
      row.interval = {std::max(-1.0, row.interval.low), std::min(1.0, row.interval.high)};
    const bool mcnemar = kind == ComparedQuantity::Kind::kShare && one_each;
    row.p = mcnemar ? paired.p_sign : paired.p_permutation;
  }
  if (nothing_random() || paired.rises + paired.falls == 0) row.p = kNan;
  result_.quantities.push_back(row);
  return true;
}

void Comparer::choose_measure() {
  if (!options_.measure.empty()) {
    im_a_ = a_.data->measure(options_.measure);
    im_b_ = b_.data->measure(options_.measure);
  } else {
    const std::vector<RunMeasure> of_a = known_measures(*a_.data), of_b = known_measures(*b_.data);
    for (const RunMeasure& each : of_a) {
      const auto same = std::ranges::find(of_b, each.name, &RunMeasure::name);
      if (same == of_b.end() || !im_a_.name.empty()) continue;
      im_a_ = each;
      im_b_ = *same;
    }
  }
  result_.measure = im_a_.name;
  result_.units = im_a_.units;
}

void Comparer::add_curves(std::size_t state, const RunValues& of_a, const RunValues& of_b) {
  const auto observed = [](const ConfigurationView& side, const auto& common,
                           const RunValues& exceeds, const std::vector<double>& im) {
    const std::vector<double> cases = side.data->file().numbers("runs/analysis_case");
    std::vector<statistics::Observation> seen;
    for (const auto& [run, group] : common)
      if (im[run] > 0)
        seen.push_back({im[run], exceeds.at(run) > 0, group, static_cast<std::size_t>(cases[run])});
    return seen;
  };
  ComparedCurves row;
  row.state = state;
  row.name = a_.data->limit_states()[state].name;
  const std::vector<statistics::Observation> seen_a = observed(a_, result_.pairs.common_a, of_a,
                                                               im_a_.values),
                                             seen_b = observed(b_, result_.pairs.common_b, of_b,
                                                               im_b_.values);
  if (seen_a.empty() || seen_b.empty()) return;
  const double first = seen_a.front().im;
  const auto is_first = [&](const statistics::Observation& each) { return each.im == first; };
  if (std::ranges::all_of(seen_a, is_first) && std::ranges::all_of(seen_b, is_first)) return;
  row.a = curve_of_event(*a_.data, a_.configuration, im_a_, seen_a);
  row.b = curve_of_event(*b_.data, b_.configuration, im_b_, seen_b);
  const std::size_t exceeded = row.a.fit.exceeded + row.b.fit.exceeded;
  const bool alike = row.a.capacities.has_value() == row.b.capacities.has_value();
  row.p = kNan;
  if (alike && exceeded > 0 && exceeded < row.a.fit.runs + row.b.fit.runs) {
    const statistics::FragilityComparison seen =
        row.a.capacities
            ? statistics::compare_capacities(row.a.brackets, row.b.brackets, options_.resamples,
                                             options_.seed)
            : statistics::compare_fragilities(seen_a, seen_b, options_.resamples, options_.seed);
    row.likelihood_ratio = seen.likelihood_ratio;
    if (!nothing_random()) row.p = seen.p_permutation.value_or(kNan);
  }
  result_.curves.push_back(std::move(row));
}

void Comparer::compare_states() {
  const std::vector<LimitState>&states_a = a_.data->limit_states(),
        &states_b = b_.data->limit_states();
  std::set<std::string> common;
  for (std::size_t i = 0; i < states_a.size(); ++i)
    for (std::size_t j = 0; j < states_b.size(); ++j) {
      if (states_a[i].name != states_b[j].name || !same_state(states_a, i, states_b, j)) continue;
      common.insert(states_a[i].name);
      const RunValues of_a = by_run(runs_a_, a_.data->exceedances(i, runs_a_));
      const RunValues of_b = by_run(runs_b_, b_.data->exceedances(j, runs_b_));
      if (add(ComparedQuantity::Kind::kShare, states_a[i].name, "1", of_a, of_b))
        result_.quantities.back().words = states_a[i].words;
      if (!im_a_.name.empty()) add_curves(i, of_a, of_b);
    }
  for (const auto* states : {&states_a, &states_b})
    for (const LimitState& state : *states)
      if (common.insert(state.name).second)
        result_.not_common.push_back("limit state " + state.name);
}

void Comparer::compare_demands() {
  const auto asked = [&](const ConfigurationView& side) {
    return options_.demands.empty()
               ? demands_of(*side.data, side.configuration)
               : demands_named(*side.data, side.configuration, options_.demands);
  };
  const std::vector<NamedDemand> demands_a = asked(a_), demands_b = asked(b_);
  std::set<std::string> common;
  for (const NamedDemand& each : demands_a) {
    const auto other = std::ranges::find(demands_b, each.name, &NamedDemand::name);
    if (other == demands_b.end()) continue;
    const RunValues of_a = by_run(runs_a_, values_of_runs(*a_.data, each, runs_a_));
    const RunValues of_b = by_run(runs_b_, values_of_runs(*b_.data, *other, runs_b_));
    if (!add(ComparedQuantity::Kind::kMean, each.name, each.units, of_a, of_b)) continue;
    add(ComparedQuantity::Kind::kMedian, each.name, each.units, of_a, of_b);
    common.insert(each.name);
  }
  for (const auto* demands : {&demands_a, &demands_b})
    for (const NamedDemand& each : *demands)
      if (common.insert(each.name).second) result_.not_common.push_back(each.name);
}

void Comparer::count_overturned() {
  const std::vector<std::string> outcomes_a = a_.data->file().strings("runs/outcome"),
                                 outcomes_b = b_.data->file().strings("runs/outcome");
  const std::string fell = name_of(Outcome::kOverturned);
  for (const RunPairs::Pair& pair : result_.pairs.pairs) {
    for (const std::size_t run : pair.a) result_.overturned += outcomes_a[run] == fell;
    for (const std::size_t run : pair.b) result_.overturned += outcomes_b[run] == fell;
  }
}

template <class Row>
std::size_t adjust_family(const std::vector<Row*>& rows) {
  std::vector<double> p;
  for (const Row* row : rows) p.push_back(row->p);
  const std::vector<double> adjusted = statistics::holm_adjusted(p);
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i]->p_holm = adjusted[i];
  return static_cast<std::size_t>(
      std::ranges::count_if(p, [](double each) { return !std::isnan(each); }));
}

void Comparer::adjust() {
  const auto tests_of = [this](ComparedQuantity::Kind kind) {
    std::vector<ComparedQuantity*> family;
    for (ComparedQuantity& row : result_.quantities)
      if (row.kind == kind) family.push_back(&row);
    return adjust_family(family);
  };
  std::vector<ComparedCurves*> curves;
  for (ComparedCurves& row : result_.curves) curves.push_back(&row);
  result_.tests = {tests_of(ComparedQuantity::Kind::kShare), adjust_family(curves),
                   tests_of(ComparedQuantity::Kind::kMean),
                   tests_of(ComparedQuantity::Kind::kMedian)};
  result_.smallest_p = std::min(1.0, std::exp2(1 - static_cast<double>(result_.pairs.groups)));
}

}  // namespace

StudyComparison compare_studies(const ConfigurationView& a, const ConfigurationView& b,
                                const ComparisonOptions& options) {
  return Comparer(a, b, options).compare();
}

}  // namespace gurney::study
