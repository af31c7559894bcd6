#include "studies/loss/study_loss.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <set>

#include "engine/base/error.h"
#include "engine/config/document.h"
#include "engine/config/nearest_name.h"
#include "studies/analysis/curve_audit.h"
#include "studies/analysis/demand_runs.h"
#include "studies/analysis/fitted_curve.h"
#include "studies/analysis/scale_factors.h"
#include "studies/statistics/quantiles.h"

namespace gurney::study {
namespace {

using statistics::Interval;

constexpr int kResamples = 999;
constexpr double kTail = 0.9, kDecade = 10;

/// Under which name an item may have its price: its own, or that of its equipment.
std::map<std::string, std::string> equipment_of_items(const StudyReader& file) {
  config::Document document(file.job_text(), file.path() + " (its job)");
  const config::Node* const given = document.tree().find("item");
  std::map<std::string, std::string> found;
  const auto note = [&](const config::Node& item) {
    const config::Node *const equipment = item.find("equipment"), *const name = item.find("name");
    if (equipment == nullptr) return;
    const std::string stem = std::filesystem::path(equipment->text).stem().string();
    found[name == nullptr ? stem : name->text] = stem;
  };
  if (given != nullptr && given->kind == config::Node::Kind::kTable) note(*given);
  if (given != nullptr && given->kind == config::Node::Kind::kArray)
    for (const config::Node& each : given->elements) note(each);
  return found;
}

/// `icu_ventilator 2` is one more icu_ventilator.
std::string without_number(const std::string& name) {
  const std::size_t end = name.find_last_not_of("0123456789");
  return end == std::string::npos || name[end] != ' ' ? name : name.substr(0, end);
}

/// Losses of one run.
struct RunLoss {
  std::size_t run = 0, record = 0, analysis_case = 0;
  double im = 0;
  std::vector<ItemLoss> items;

  double sum(double ItemLoss::*of) const {
    double total = 0;
    for (const ItemLoss& each : items) total += each.*of;
    return total;
  }
  bool out_of_use() const {
    return std::ranges::any_of(items,
                               [](const ItemLoss& each) { return each.service == Service::kLost; });
  }
  bool serious() const {
    return std::ranges::any_of(
        items, [](const ItemLoss& each) { return each.injury == Injury::kSerious; });
  }
};

using IsEvent = std::function<bool(const RunLoss&)>;

constexpr double kSameIntensity = 1e-9;  // rounding of a unit, over the intensity

/// Outcomes of an event in runs, or after an IDA the capacities of its analysis cases, by records.
class EventOutcomes {
 public:
  EventOutcomes(const std::vector<statistics::Observation>& seen, bool traced) {
    if (traced)
      capacities_ = statistics::ida_capacities(seen);
    else
      table_.emplace(seen);
  }

  EventCurve curve() const {
    return table_ ? EventCurve(table_->stripes()) : EventCurve(capacities_);
  }

  /// Curve of a bootstrap sample that has each record so often.
  EventCurve resampled(const std::vector<int>& times) const {
    if (table_) return EventCurve(table_->resampled(times));
    std::vector<statistics::Capacity> drawn;
    for (statistics::Capacity each : capacities_) {
      each.weight *= times[each.group];
      if (each.weight > 0) drawn.push_back(each);
    }
    return EventCurve(drawn);
  }

 private:
  std::optional<statistics::StripeTable> table_;
  std::vector<statistics::Capacity> capacities_;
};

/// Runs, records and the bootstrap over records of one configuration.
class Runs {
 public:
  /// @param traced  the runs are those of an IDA over their im
  Runs(std::vector<RunLoss> runs, bool traced, std::uint64_t seed, int threads)
      : runs_(std::move(runs)), traced_(traced), seed_(seed), threads_(threads) {
    std::map<std::size_t, std::size_t> numbers;
    for (RunLoss& run : runs_)
      run.record = numbers.emplace(run.record, numbers.size()).first->second;
    records_ = numbers.size();
  }

  const std::vector<RunLoss>& all() const { return runs_; }
  std::size_t records() const { return records_; }

  EventOutcomes outcomes(const IsEvent& is_event) const {
    return {observations(is_event), traced_};
  }

  std::vector<statistics::Observation> observations(const IsEvent& is_event) const {
    std::vector<statistics::Observation> seen;
    for (const RunLoss& run : runs_)
      seen.push_back({run.im, is_event(run), run.record, run.analysis_case});
    return seen;
  }

  std::optional<Interval> interval(
      const std::function<double(const std::vector<int>&)>& statistic) const {
    if (static_cast<double>(records_) < statistics::kFewestGroups) return {};
    const Interval found =
        statistics::bootstrap_interval(records_, seed_, kResamples, threads_, statistic);
    // Of what no run has, resamples know no more than that.
    return found.high > 0 ? std::optional(found) : std::nullopt;
  }

 private:
  std::vector<RunLoss> runs_;
  bool traced_;
  std::uint64_t seed_;
  int threads_;
  std::size_t records_ = 0;
};

/// The mean over runs, records resampled whole.
LossEstimate mean_over(const Runs& runs, const std::function<double(const RunLoss&)>& value) {
  std::vector<double> sum(runs.records(), 0), count(runs.records(), 0);
  for (const RunLoss& run : runs.all()) {
    sum[run.record] += value(run);
    ++count[run.record];
  }
  const auto mean = [&](const std::vector<int>& times) {
    double total = 0, of = 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
      total += times[i] * sum[i];
      of += times[i] * count[i];
    }
    return total / of;
  };
  return {mean(std::vector<int>(runs.records(), 1)), runs.interval(mean)};
}

statistics::Proportion share_of(const Runs& runs, const IsEvent& is_event) {
  std::vector<statistics::GroupOutcomes> groups(runs.records());
  for (const RunLoss& run : runs.all()) {
    ++groups[run.record].runs;
    groups[run.record].happened += is_event(run) ? 1 : 0;
  }
  return statistics::grouped_proportion(groups);
}

LossAtLevel at_level(const std::string& level, const Runs& runs) {
  LossAtLevel found;
  found.level = level;
  found.runs = runs.all().size();
  found.records = runs.records();
  const auto sum = [](double ItemLoss::*of) {
    return [of](const RunLoss& run) { return run.sum(of); };
  };
  found.cost = mean_over(runs, sum(&ItemLoss::cost));
  found.days = mean_over(runs, sum(&ItemLoss::days));
  std::vector<double> drawn;
  for (const RunLoss& run : runs.all()) {
    drawn.push_back(run.sum(&ItemLoss::drawn));
    found.low += run.sum(&ItemLoss::low) / static_cast<double>(found.runs);
    found.high += run.sum(&ItemLoss::high) / static_cast<double>(found.runs);
  }
  found.median = statistics::quantile_of(drawn, 0.5);
  found.p90 = statistics::quantile_of(drawn, kTail);
  found.largest = std::ranges::max(drawn);
  found.any = share_of(runs, [](const RunLoss& run) { return run.sum(&ItemLoss::cost) > 0; });
  found.out_of_use = share_of(runs, &RunLoss::out_of_use);
  found.serious = share_of(runs, &RunLoss::serious);
  return found;
}

/// What a number of an item adds from each of its values to the next, with the event of that.
struct Step {
  double amount = 0, threshold = 0;
  IsEvent is_event;
};

std::vector<Step> steps_of(const Runs& runs, std::size_t item, double ItemLoss::*of) {
  std::set<double> values;
  for (const RunLoss& run : runs.all()) values.insert(run.items[item].*of);
  std::vector<Step> steps;
  double before = 0;
  for (const double value : values) {
    if (!(value > 0)) continue;
    steps.push_back({value - before, value, [item, of, value](const RunLoss& run) {
                       return run.items[item].*of >= value;
                     }});
    before = value;
  }
  return steps;
}

/// The expected sum of steps, each with its probability or rate.
class Expectation {
 public:
  Expectation(const Runs& runs, const std::vector<Step>& steps) : runs_(runs) {
    for (const Step& step : steps) {
      amounts_.push_back(step.amount);
      events_.push_back(runs.outcomes(step.is_event));
    }
  }

  bool is_fitted() const {
    return std::ranges::all_of(events_,
                               [](const EventOutcomes& each) { return each.curve().is_fitted(); });
  }

  LossEstimate of(const std::function<double(const EventCurve&)>& chance) const {
    const auto sum = [&](const std::vector<int>& times) {
      double total = 0;
      for (std::size_t i = 0; i < events_.size(); ++i)
        total += amounts_[i] * chance(events_[i].resampled(times));
      return total;
    };
    return {sum(std::vector<int>(runs_.records(), 1)), runs_.interval(sum)};
  }

 private:
  const Runs& runs_;
  std::vector<double> amounts_;
  std::vector<EventOutcomes> events_;
};

/// Costs, days, service and injury of all items as sums of steps.
struct Expectations {
  explicit Expectations(const Runs& runs, std::size_t items)
      : cost(runs, all_steps(runs, items, &ItemLoss::cost)),
        days(runs, all_steps(runs, items, &ItemLoss::days)),
        out_of_use(runs, {{1, 0, &RunLoss::out_of_use}}),
        serious(runs, {{1, 0, &RunLoss::serious}}) {
    std::vector<double> drawn;
    for (const RunLoss& run : runs.all()) drawn.push_back(run.sum(&ItemLoss::drawn));
    for (const double value : exceedance_costs(drawn)) {
      const auto exceeded = [value](const RunLoss& run) {
        return run.sum(&ItemLoss::drawn) > value;
      };
      exceeding.emplace_back(value, Expectation(runs, {{1, value, exceeded}}));
    }
  }

  static std::vector<Step> all_steps(const Runs& runs, std::size_t items, double ItemLoss::*of) {
    std::vector<Step> all;
    for (std::size_t i = 0; i < items; ++i)
      for (Step& step : steps_of(runs, i, of)) all.push_back(std::move(step));
    return all;
  }

  ExpectedLoss of(double im, const std::function<double(const EventCurve&)>& chance) const {
    ExpectedLoss found{
        im, cost.of(chance), days.of(chance), out_of_use.of(chance), serious.of(chance), {}};
    for (const auto& [value, event] : exceeding) {
      LossExceedance at{value, event.of(chance), event.is_fitted()};
      if (!found.exceedance.empty()) cut(at.chance, found.exceedance.back().chance);
      found.exceedance.push_back(at);
    }
    return found;
  }

  static void cut(LossEstimate& chance, const LossEstimate& of_less) {
    chance.value = std::min(chance.value, of_less.value);
    if (!chance.interval || !of_less.interval) return;
    chance.interval->low = std::min(chance.interval->low, of_less.interval->low);
    chance.interval->high = std::min(chance.interval->high, of_less.interval->high);
  }

  Expectation cost, days, out_of_use, serious;
  std::vector<std::pair<double, Expectation>> exceeding;
};

/// States of an item whose expected cost is the threshold or more: "a or b".
std::string states_from(const Consequences& consequences, const PricedItem& item,
                        double threshold) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < consequences.limit_states().size(); ++i) {
    const Consequence* const of = consequences.of(item.equipment, i);
    if (of != nullptr && mean_of(item.price) * mean_of(of->cost_ratio) >= threshold)
      names.push_back(consequences.limit_states()[i].name);
  }
  return fmt::format("{}", fmt::join(names, " or "));
}

/// Items and which of the states each reaches, run by run.
class ReachedStates {
 public:
  ReachedStates(const StudyData& data, const Consequences& consequences)
      : values_(data.file()), states_(consequences.limit_states()) {
    for (const LimitState& state : states_) {
      const bool known = !state.is_simple() || data.file().has_column(table_of(state.quantity.of) +
                                                                      "/" + state.quantity.column);
      known_.push_back(known);
      if (!known) missing_.push_back(state.name);
    }
  }

  const std::vector<std::string>& missing() const { return missing_; }

  std::vector<bool> of(std::size_t run, const std::string& item) {
    std::vector<bool> reached;
    const auto of_item = [&](Quantity quantity) {
      if (quantity.item.empty()) quantity.item = item;
      return quantity.item == item ? values_(run, quantity) : std::vector<double>();
    };
    for (std::size_t i = 0; i < states_.size(); ++i)
      reached.push_back(known_[i] && exceeded(states_, i, of_item));
    return reached;
  }

 private:
  FileValues values_;
  const std::vector<LimitState>& states_;
  std::vector<bool> known_;
  std::vector<std::string> missing_;
};

/// For each run the number of the sample of prices and ratios: the same for one record, angle and
/// draw, at any level and in any configuration.
std::vector<std::uint64_t> price_samples(const StudyData& data) {
  const StudyReader& file = data.file();
  const auto whole = [&](const std::string& column, std::size_t runs) {
    return file.has_column(column) ? file.numbers(column) : std::vector<double>(runs);
  };
  const std::vector<double> record = file.numbers("runs/record");
  const std::vector<double> angle = whole("runs/angle", record.size()),
                            draw = whole("runs/draw", record.size());
  using Case = std::array<double, 3>;
  std::map<Case, std::uint64_t> numbers;
  for (std::size_t run = 0; run < record.size(); ++run)
    numbers[{record[run], angle[run], draw[run]}] = 0;
  std::uint64_t next = 0;
  for (auto& [of, number] : numbers) number = next++;
  std::vector<std::uint64_t> samples;
  for (std::size_t run = 0; run < record.size(); ++run)
    samples.push_back(numbers.at({record[run], angle[run], draw[run]}));
  return samples;
}

Runs runs_of(const StudyData& data, std::size_t configuration, const Consequences& consequences,
             ReachedStates& reached, const StudyLoss& loss, const RunMeasure& measure,
             int threads) {
  std::vector<RunLoss> runs;
  const std::uint64_t seed = data.study().seed;
  const std::vector<double> cases = data.file().numbers("runs/analysis_case");
  const std::vector<std::uint64_t> samples = price_samples(data);
  for (const std::size_t run : data.runs_of(configuration)) {
    if (!(measure.values[run] > 0)) continue;
    RunLoss each{
        run, data.record_of(run), static_cast<std::size_t>(cases[run]), measure.values[run], {}};
    for (const PricedItem& item : loss.items)
      each.items.push_back(
          item_loss(consequences, item, reached.of(run, item.name), seed, samples[run]));
    runs.push_back(std::move(each));
  }
  return Runs(std::move(runs), data.traces(configuration, measure), seed, threads);
}

void add_levels(const StudyData& data, const Runs& runs, int threads, StudyLoss& loss) {
  const RunLevels levels = run_levels(data);
  if (levels.traced) return;
  for (std::size_t i = 0; i < levels.texts.size(); ++i) {
    std::vector<RunLoss> chosen;
    for (const RunLoss& run : runs.all())
      if (levels.of_run[run.run] == i) chosen.push_back(run);
    if (chosen.empty()) continue;
    loss.levels.push_back(
        at_level(levels.texts[i], Runs(std::move(chosen), false, data.study().seed, threads)));
  }
}

/// Facts for the cautions of one step; those of the whole study, its factors and records, are left out.
CurveAudit audit_of_step(const StudyData& data, std::size_t configuration,
                         const RunMeasure& measure, const Runs& runs, const IsEvent& is_event) {
  CurveAudit audit =
      curve_of_event(data, configuration, measure, runs.observations(is_event)).audit;
  audit.factors = {};
  audit.fewest = 0;
  audit.overturned = 0;
  return audit;
}

/// Cautions of curves beyond the runs, of those of few runs, and of intensities beyond them.
void add_cautions_of_curves(const Runs& runs, const ReportUnit& unit, StudyLoss& loss) {
  const auto [low, high] = std::ranges::minmax(runs.all(), {}, &RunLoss::im);
  for (const FittedStep& step : loss.steps)
    if (step.curve.is_fitted())
      for (const std::string& caution : cautions(step.audit, unit))
        loss.cautions.push_back(fmt::format("{}, {}: {}", step.item, step.states, caution));
  for (const ExpectedLoss& at : loss.at)
    if (at.im < low.im * (1 - kSameIntensity) || at.im > high.im * (1 + kSameIntensity))
      loss.cautions.push_back(
          fmt::format("{0:g} {1} lies beyond the runs, {2:.3g} to {3:.3g} {1}: its loss is that of "
                      "curves alone",
                      at.im / unit.in_si, unit.name, low.im / unit.in_si, high.im / unit.in_si));
}

void add_cautions(const StudyData& data, std::size_t configuration, StudyLoss& loss) {
  if (!loss.unpriced.empty())
    loss.cautions.push_back(
        fmt::format("no price, and so not counted: {}", fmt::join(loss.unpriced, ", ")));
  if (!loss.missing.empty())
    loss.cautions.push_back(fmt::format("the file does not have what these states ask for: {}",
                                        fmt::join(loss.missing, ", ")));
  if (static_cast<double>(loss.records) < statistics::kFewestGroups)
    loss.cautions.push_back(fmt::format("{} records: fewer than {:g} give no interval",
                                        loss.records, statistics::kFewestGroups));
  for (const FittedStep& step : loss.steps)
    if (!step.curve.is_fitted())
      loss.cautions.push_back(fmt::format(
          "{}, {}: {}; the shares of the runs count instead of a curve, nothing below the lowest "
          "intensity",
          step.item, step.states, text(step.curve.status())));
  if (loss.steps.empty())
    loss.cautions.push_back("no run costs anything: a loss below the resolution of these runs");
  const ScaleFactors factors = scale_factors(data, configuration);
  if (factors.any() && factors.above() > 0)
    loss.cautions.push_back("scale factors " + factors.text());
}

StudyLoss loss_of(const StudyData& data, std::size_t configuration,
                  const Consequences& consequences, ReachedStates& reached,
                  const LossRequest& request) {
  StudyLoss loss;
  loss.configuration = data.configurations()[configuration];
  const RunMeasure measure = data.measure(request.measure);
  loss.measure = {measure.name, measure.units, {}};
  loss.failed = data.failed(configuration);
  loss.missing = reached.missing();
  loss.items = priced_items(data, configuration, consequences, loss.unpriced);
  require(!loss.items.empty(),
          fmt::format("{}: none of its items has a price in {}: {}; it has {}", data.file().path(),
                      consequences.path(), fmt::join(loss.unpriced, ", "),
                      fmt::join(consequences.priced_items(), ", ")));
  const Runs runs =
      runs_of(data, configuration, consequences, reached, loss, measure, request.threads);
  loss.runs = runs.all().size();
  loss.records = runs.records();
  if (loss.runs == 0) return loss;
  add_levels(data, runs, request.threads, loss);
  const statistics::HazardCurve* const hazard = data.hazard_over(measure);
  for (std::size_t i = 0; i < loss.items.size(); ++i)
    for (const Step& step : steps_of(runs, i, &ItemLoss::cost)) {
      FittedStep fitted;
      fitted.item = loss.items[i].name;
      fitted.states = states_from(consequences, loss.items[i], step.threshold);
      fitted.cost = step.amount;
      fitted.happened = static_cast<std::size_t>(std::ranges::count_if(runs.all(), step.is_event));
      fitted.curve = runs.outcomes(step.is_event).curve();
      fitted.audit = audit_of_step(data, configuration, measure, runs, step.is_event);
      if (hazard != nullptr) fitted.rate = fitted.curve.rate(*hazard);
      loss.steps.push_back(std::move(fitted));
    }
  const Expectations expected(runs, loss.items.size());
  for (const double im : request.at)
    loss.at.push_back(
        expected.of(im, [im](const EventCurve& curve) { return curve.probability(im); }));
  if (hazard != nullptr)
    loss.annual = expected.of(0, [hazard](const EventCurve& curve) { return curve.rate(*hazard); });
  if (const std::string over = data.other_hazard(measure); !over.empty())
    loss.cautions.push_back(no_rate_text(over));
  add_cautions(data, configuration, loss);
  add_cautions_of_curves(runs, report_unit(data, loss.measure), loss);
  return loss;
}

}  // namespace

std::vector<PricedItem> priced_items(const StudyData& data, std::size_t configuration,
                                     const Consequences& consequences,
                                     std::vector<std::string>& unpriced) {
  std::vector<PricedItem> priced;
  const std::map<std::string, std::string> equipment = equipment_of_items(data.file());
  const std::vector<std::string> names = data.file().strings("items/item");
  const auto [first, last] =
      data.file().rows_of_runs("items").at(data.runs_of(configuration).front());
  for (std::size_t row = first; row < last; ++row) {
    const std::string plain = without_number(names[row]);
    const auto of_job = equipment.find(names[row]);
    std::vector<std::string> tried{names[row], plain.substr(plain.rfind('/') + 1)};
    if (of_job != equipment.end()) tried.insert(tried.begin() + 1, of_job->second);
    const auto found = std::ranges::find_if(
        tried, [&](const std::string& name) { return consequences.price_of(name) != nullptr; });
    if (found == tried.end())
      unpriced.push_back(names[row]);
    else
      priced.push_back({names[row], *found, *consequences.price_of(*found)});
  }
  return priced;
}

ItemLoss item_loss(const Consequences& consequences, const PricedItem& item,
                   const std::vector<bool>& reached, std::uint64_t seed, std::uint64_t sample) {
  ItemLoss loss;
  const double price = sampled(item.price, item.equipment + "/price", seed, sample);
  for (std::size_t i = 0; i < reached.size(); ++i) {
    const Consequence* const of = reached[i] ? consequences.of(item.equipment, i) : nullptr;
    if (of == nullptr) continue;
    const double cost = mean_of(item.price) * mean_of(of->cost_ratio);
    const std::string name =
        fmt::format("{}/{}", item.equipment, consequences.limit_states()[i].name);
    if (cost >= loss.cost)  // the worst state by its expected cost, so that steps are the same
      loss.drawn = price * sampled(of->cost_ratio, name + "/cost_ratio", seed, sample);
    loss.cost = std::max(loss.cost, cost);
    loss.low = std::max(loss.low, item.price.low * of->cost_ratio.low);
    loss.high = std::max(loss.high, item.price.high * of->cost_ratio.high);
    loss.days = std::max(loss.days, mean_of(of->days));
    loss.injury = std::max(loss.injury, of->injury);
    loss.service = std::max(loss.service, of->service);
  }
  return loss;
}

std::vector<double> exceedance_costs(const std::vector<double>& costs) {
  double least = 0, most = 0;
  for (const double each : costs) {
    most = std::max(most, each);
    if (each > 0) least = least > 0 ? std::min(least, each) : each;
  }
  if (!(least > 0)) return {};
  const std::vector<int> digits = most > kDecade * least
                                      ? std::vector<int>{1, 2, 5}
                                      : std::vector<int>{1, 2, 3, 4, 5, 6, 7, 8, 9};
  std::vector<double> found;
  const int first = static_cast<int>(std::floor(std::log10(least))) - 1;
  for (int power = first; std::pow(kDecade, power) < most; ++power)
    for (const int digit : digits) {
      const double scale = std::pow(kDecade, std::abs(power));
      const double value = power < 0 ? digit / scale : digit * scale;
      if (value < least)
        found = {value};
      else if (value < most)
        found.push_back(value);
    }
  return found;
}

std::vector<StudyLoss> study_losses(const StudyData& data, const Consequences& consequences,
                                    const LossRequest& request) {
  ReachedStates reached(data, consequences);
  std::vector<StudyLoss> all;
  for (std::size_t i = 0; i < data.configurations().size(); ++i)
    if (!data.runs_of(i).empty()) all.push_back(loss_of(data, i, consequences, reached, request));
  return all;
}

}  // namespace gurney::study
