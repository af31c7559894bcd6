#include "studies/analysis/fragility_result.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/base/error.h"
#include "studies/analysis/demands.h"
#include "studies/analysis/measure_choice.h"
#include "studies/statistics/capacity.h"
#include "studies/statistics/cloud.h"
#include "studies/statistics/fragility.h"
#include "studies/statistics/hazard.h"

namespace gurney::study {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::string intensity(const ReportUnit& unit, double im) {
  return fmt::format("{:.3g}{}{}", im / unit.in_si, unit.name == "1" ? "" : " ",
                     unit.name == "1" ? "" : unit.name);
}

constexpr int kGridPoints = 61;
constexpr std::size_t kMaxStripes = 40;  ///< more distinct intensities are a cloud, not stripes

std::vector<double> grid(const std::vector<statistics::Stripe>& stripes) {
  if (stripes.empty()) return {};
  const double low = std::log(stripes.front().im / 1.5), high = std::log(stripes.back().im * 1.5);
  std::vector<double> im;
  for (int i = 0; i < kGridPoints; ++i)
    im.push_back(std::exp(low + (high - low) * i / (kGridPoints - 1)));
  return im;
}

void judge_stripes(const statistics::StripeTable& table, const FragilityRequest& request,
                   std::uint64_t seed, FragilityResult& result) {
  result.profile = statistics::profile_intervals(table, request.confidence, true);
  result.fit_is_judged = !table.repeats_groups();
  if (!result.fit_is_judged) return;
  result.p_of_fit = statistics::p_of_fit(result.stripes, 999, seed);
}

void judge_capacities(std::uint64_t seed, FragilityResult& result) {
  if (!result.capacities->curve) return;
  result.fit_is_judged = result.brackets.size() == result.records;
  if (result.fit_is_judged)
    result.p_of_fit = statistics::p_of_lognormal(result.brackets, *result.capacities, 499, seed);
}

/// The fit of a cloud is judged by its R2.
void judge_cloud(double limit, const FragilityRequest& request, FragilityResult& result) {
  if (result.cloud_curve)
    result.band =
        statistics::cloud_band(*result.cloud, result.demands, limit, result.im, request.confidence);
}

const FragilityResult* find(const std::vector<FragilityResult>& results, const std::string& state,
                            const std::string& configuration) {
  for (const FragilityResult& each : results)
    if (each.state == state && each.configuration == configuration) return &each;
  return nullptr;
}

double probability(const FragilityResult& result, std::size_t stripe) {
  if (const auto curve = result.curve()) return curve->probability(result.stripes[stripe].im);
  return result.isotonic[stripe];
}

/// How much more likely a worse level is than a milder one, at most.
double crossing(const std::vector<double>& exceedance) {
  double largest = 0;
  for (std::size_t i = 1; i < exceedance.size(); ++i)
    largest = std::max(largest, exceedance[i] - exceedance[i - 1]);
  return largest;
}

constexpr double kSmallCrossing = 0.005;  // what a table in per cent does not show

}  // namespace

bool SiteRate::is_supported() const {
  return std::isfinite(rate) && complete() && share_below <= kLargestShare &&
         share_above <= kLargestShare;
}

SiteRate site_rate(const statistics::LognormalCurve& curve, const statistics::FragilityBand& band,
                   const CurveAudit& audit, const statistics::HazardCurve& hazard) {
  SiteRate rate;
  static_cast<statistics::MeanRate&>(rate) = statistics::mean_rate(curve, hazard);
  rate.lowest = audit.lowest;
  rate.highest = audit.highest;
  rate.of_lowest = hazard.rate(audit.lowest);
  rate.has_interval = !band.outline.empty();
  rate.interval = statistics::rate_interval(band.outline, hazard);
  if (rate.of_lowest && rate.interval.high > *rate.of_lowest) rate.interval.high = kInfinity;
  if (rate.of_lowest && rate.rate > *rate.of_lowest) {
    rate.rate = std::numeric_limits<double>::quiet_NaN();
    rate.share_below = 1;
    return rate;
  }
  if (!(rate.rate > 0)) return rate;
  const double up_to_highest = statistics::rate_between(curve, hazard, 0, audit.highest);
  rate.share_below = statistics::rate_between(curve, hazard, 0, audit.lowest) / rate.rate;
  // The end of a table counts as above the highest level if the table reaches beyond it.
  if (hazard.pieces().back().high > audit.highest)
    rate.share_above = std::max(0.0, 1 - up_to_highest / rate.rate);
  return rate;
}

std::string rate_interval_text(const SiteRate& rate, const CurveAudit& audit) {
  const statistics::Interval of =
      rate.has_interval ? rate.interval : statistics::Interval{0, kInfinity};
  return interval_text(of, 1, 3, audit);
}

std::string rate_text(const SiteRate& rate, const CurveAudit& audit) {
  if (std::isnan(rate.rate)) return "no annual rate";
  return fmt::format("{:.3g} times a year (95 %: {}), {:.2g} % in 50 years", rate.rate,
                     rate_interval_text(rate, audit),
                     100 * statistics::probability_in(50, rate.rate));
}

std::vector<std::string> cautions(const SiteRate& rate, const ReportUnit& unit) {
  std::vector<std::string> all;
  if (std::isnan(rate.rate))
    return {fmt::format(
        "the curve and the hazard give more than the rate of motions above the lowest analysed "
        "intensity, {:.3g} a year at {}: the runs do not support a rate; analyse weaker motions",
        *rate.of_lowest, intensity(unit, rate.lowest))};
  if (rate.share_below > kLargestShare)
    all.push_back(
        fmt::format("{:.0f} % of the rate is from motions below the lowest analysed "
                    "intensity, {}, where only the form of the curve counts",
                    100 * rate.share_below, intensity(unit, rate.lowest)));
  if (rate.share_above > kLargestShare)
    all.push_back(
        fmt::format("{:.0f} % of the rate is from motions above the highest analysed "
                    "intensity, {}, where only the form of the curve counts",
                    100 * rate.share_above, intensity(unit, rate.highest)));
  if (!rate.complete())
    all.push_back(
        fmt::format("the hazard curve is too short: stronger motions add at most {:.2g} a year, "
                    "and P is {:.2g} at its lower end",
                    rate.most_above, rate.below));
  return all;
}

Eigen::Matrix2d FragilityResult::covariance() const {
  if (by_cloud()) return cloud_covariance;
  return capacities ? capacities->covariance : fit.cluster_covariance;
}

namespace {

/// @param limit  of a cloud
FragilityResult judged(const StudyData& data, const FragilityRequest& request,
                       const RunMeasure& measure, FittedCurve fitted, double limit) {
  FragilityResult result;
  static_cast<FittedCurve&>(result) = std::move(fitted);
  result.configuration = data.configurations().at(request.configuration);
  result.measure = {measure.name, measure.units, {}};
  result.failed = data.failed(request.configuration);
  result.runs = result.fit.runs;
  result.exceeded = result.fit.exceeded;
  result.records = result.fit.groups;
  const statistics::StripeTable table(result.observations);
  result.im = grid(table.stripes());
  result.band = band_of_curve(result, result.im, request.confidence);
  if (table.stripes().size() <= kMaxStripes) {
    result.stripes = table.stripes();
    result.isotonic = statistics::isotonic_curve(result.stripes);
  }
  if (result.by_cloud())
    judge_cloud(limit, request, result);
  else if (result.capacities)
    judge_capacities(data.study().seed, result);
  else
    judge_stripes(table, request, data.study().seed, result);
  const statistics::HazardCurve* const hazard = data.hazard_over(measure);
  result.audit.hazard_over = data.other_hazard(measure);
  if (hazard != nullptr && result.curve())
    result.rate = site_rate(*result.curve(), result.band, result.audit, *hazard);
  return result;
}

}  // namespace

FragilityResult fragility_of(const StudyData& data, const FragilityRequest& request) {
  const RunMeasure measure = data.measure(request.measure);
  const LimitState& state = data.limit_states().at(request.state);
  FragilityResult result =
      judged(data, request, measure,
             fitted_curve(data, request.state, request.configuration, measure, request.method),
             state.limit);
  result.state = state.name;
  result.words = state.words;
  if (result.cloud) result.demand_units = units_of(state.quantity);
  return result;
}

FragilityResult fragility_of_outcomes(const StudyData& data,
                                      const std::map<std::size_t, bool>& exceeded,
                                      const FragilityRequest& request) {
  const RunMeasure measure = data.measure(request.measure);
  return judged(data, request, measure,
                curve_of_event(data, request.configuration, measure,
                               data.observations(exceeded, request.configuration, measure)),
                0);
}

std::vector<FragilityResult> fragilities_of(const StudyData& data) {
  std::vector<FragilityResult> all;
  for (std::size_t i = 0; i < data.configurations().size(); ++i)
    for (std::size_t state = 0; state < data.limit_states().size() && !data.runs_of(i).empty();
         ++state)
      all.push_back(fragility_of(data, {.state = state, .configuration = i}));
  return all;
}

std::vector<PerformanceTable> performance_tables(const StudyData& data,
                                                 const std::vector<FragilityResult>& results) {
  std::vector<PerformanceTable> tables;
  for (const std::string& configuration : data.configurations()) {
    PerformanceTable table{configuration, {}, {}, {}};
    std::vector<const FragilityResult*> of_levels;
    for (const std::size_t state : data.performance()) {
      const std::string& name = data.limit_states()[state].name;
      const FragilityResult* const found = find(results, name, configuration);
      if (found == nullptr || found->stripes.empty()) break;
      table.levels.push_back(name);
      of_levels.push_back(found);
    }
    if (of_levels.empty() || of_levels.size() < data.performance().size()) continue;
    for (std::size_t i = 0; i < of_levels.front()->stripes.size(); ++i) {
      std::vector<double> exceedance;
      for (const FragilityResult* level : of_levels) exceedance.push_back(probability(*level, i));
      table.im.push_back(of_levels.front()->stripes[i].im);
      table.at.push_back(statistics::level_probabilities(exceedance));
      table.at.back().crossed = crossing(exceedance) > kSmallCrossing;
    }
    tables.push_back(std::move(table));
  }
  return tables;
}

namespace {

constexpr double kInProportion = 1e-6;  // of logarithms: more than the rounding of two measures

/// The runs of a configuration that have both measures, in those two.
using Seen = std::array<std::vector<statistics::Observation>, 2>;

double ln_ratio(const Seen& seen, std::size_t first, double power, std::size_t run) {
  return std::log(seen[1 - first][run].im) - power * std::log(seen[first][run].im);
}

/// Ratio of each analysis case, which its runs share; none where they differ.
std::optional<std::map<std::size_t, double>> ratios(const Seen& seen, std::size_t first,
                                                    double power) {
  std::map<std::size_t, double> of_case;
  for (std::size_t run = 0; run < seen[first].size(); ++run) {
    const double ratio = ln_ratio(seen, first, power, run);
    const double own = of_case.try_emplace(seen[first][run].analysis_case, ratio).first->second;
    if (std::abs(ratio - own) > kInProportion) return {};
  }
  return of_case;
}

/// The plane with its two measures exchanged.
void exchange(statistics::VectorFit& fit) {
  Eigen::PermutationMatrix<3> to;
  to.indices() << 1, 0, 2;
  fit.plane = to * fit.plane;
  fit.t.reverseInPlace();
  for (Eigen::Matrix3d* each : {&fit.covariance, &fit.cluster_covariance})
    *each = to * *each * to.transpose();
}

statistics::FragilityFit of_capacities(const std::vector<statistics::Observation>& observations) {
  const auto fit = statistics::fit_capacities(statistics::ida_capacities(observations));
  statistics::FragilityFit alone;
  alone.status = fit.status;
  alone.curve = fit.curve;
  alone.log_likelihood = fit.log_likelihood;
  return alone;
}

/// The capacities of an IDA in the plane of both measures.
void fit_brackets(const StudyData& data, std::size_t configuration, const Seen& seen,
                  VectorResult& result) {
  for (const std::size_t first : {0, 1}) {
    if (!data.traces(configuration, result.measures[first])) continue;
    for (const double power : {1.0, 0.0}) {
      const auto of_case = ratios(seen, first, power);
      if (!of_case) continue;
      const auto brackets = statistics::ida_capacities(seen[first]);
      std::vector<statistics::VectorCapacity> capacities;
      for (const statistics::Capacity& each : brackets)
        capacities.push_back({{std::log(each.low), std::log(each.high), each.weight},
                              of_case->at(each.analysis_case),
                              each.group});
      result.fit = statistics::fit_vector_capacities(capacities, power);
      if (first == 1) exchange(result.fit);
      audit_brackets(data, configuration, brackets, result.audit);
      result.alone[first] = of_capacities(seen[first]);
      if (power == 1) result.alone[1 - first] = of_capacities(seen[1 - first]);
      result.audit.effective = result.fit.degrees > 0 ? result.fit.degrees + 2 : 0;
      return;
    }
  }
  throw Error(fmt::format(
      "{}: of two measures of an IDA one must grow with the factor on the record, and the other in "
      "proportion to it or not at all: {} and {} do otherwise, so that a capacity in the one does "
      "not belong to one value of the other",
      data.file().path(), result.measures[0].name, result.measures[1].name));
}

void fit_outcomes(const Seen& seen, VectorResult& result) {
  std::vector<statistics::CloudPoint> points;
  for (const statistics::VectorObservation& each : result.runs)
    points.push_back({.im = each.first, .edp = each.second, .group = each.group});
  result.fit = statistics::fit_vector(result.runs);
  result.audit.outcomes = result.fit.runs;
  result.audit.exceeded = result.fit.exceeded;
  result.audit.effective = statistics::effective_groups(points);
  result.audit.fewest = statistics::kFewestGroups;
  for (const std::size_t i : {0, 1}) result.alone[i] = statistics::fit_fragility(seen[i]);
}

}  // namespace

VectorResult vector_of(const StudyData& data, std::size_t state, std::size_t configuration,
                       const MeasurePair& measures) {
  VectorResult result;
  result.configuration = data.configurations().at(configuration);
  result.state = data.limit_states().at(state).name;
  result.words = data.limit_states()[state].words;
  result.failed = data.failed(configuration);
  result.measures = {data.measure(measures[0]), data.measure(measures[1])};
  require(result.measures[0].name != result.measures[1].name,
          fmt::format("{}: the second measure must not be the first, {}", data.file().path(),
                      result.measures[0].name));
  const std::vector<std::size_t>& runs = data.runs_of(configuration);
  const std::vector<bool> exceeds = data.exceedances(state, runs);
  const std::vector<double> cases = data.file().numbers("runs/analysis_case");
  Seen seen;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const double first = result.measures[0].values[runs[i]];
    const double second = result.measures[1].values[runs[i]];
    if (!(first > 0 && second > 0)) {
      ++result.left_out;
      continue;
    }
    const std::size_t record = data.record_of(runs[i]);
    const auto analysis_case = static_cast<std::size_t>(cases[runs[i]]);
    result.runs.push_back({first, second, exceeds[i], record});
    seen[0].push_back({first, exceeds[i], record, analysis_case});
    seen[1].push_back({second, exceeds[i], record, analysis_case});
  }
  result.audit.factors = scale_factors(data, configuration);
  if (data.is_ida())
    fit_brackets(data, configuration, seen, result);
  else
    fit_outcomes(seen, result);
  result.audit.records = result.fit.groups;
  if (result.fit.status == statistics::VectorStatus::kFitted)
    result.audit.theta = result.audit.lowest = result.audit.highest = result.fit.theta();
  return result;
}

}  // namespace gurney::study
