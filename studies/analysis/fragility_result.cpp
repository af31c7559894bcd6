#include "studies/analysis/fragility_result.h"

#include <cmath>
#include <limits>
#include <utility>

#include "studies/analysis/demands.h"
#include "studies/analysis/measure_choice.h"
#include "studies/statistics/capacity_intervals.h"
#include "studies/statistics/fit_check.h"

namespace gurney::study {
namespace {

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
  if (const auto check = statistics::check_fit(result.stripes, 999, seed))
    result.p_of_fit = check->p_simulated;
}

/// The band of an IDA without a curve stays that of its outcomes, which supposes no model.
void judge_capacities(const FragilityRequest& request, std::uint64_t seed,
                      FragilityResult& result) {
  if (!result.capacities->curve) return;
  result.band = {};
  result.band.status = result.capacities->status;
  result.band.effective = result.audit.effective;
  result.band.too_few = has_few_records(result.audit);
  result.band.theta = result.band.beta = {0, std::numeric_limits<double>::infinity()};
  if (!result.band.too_few) {
    const double beta = result.capacities->curve->beta;
    statistics::CapacityIntervals intervals = statistics::capacity_intervals(
        result.brackets, *result.capacities, result.im, request.confidence);
    result.band.of_curve = intervals.of_curve;
    result.band.theta =
        statistics::bounded(intervals.theta, result.audit.lowest, result.audit.highest);
    result.band.beta = statistics::bounded(intervals.beta, beta, beta);
    result.band.outline = std::move(intervals.outline);
  }
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

}  // namespace

FragilityResult fragility_of(const StudyData& data, const FragilityRequest& request) {
  const RunMeasure measure = data.measure(request.measure);
  const LimitState& state = data.limit_states().at(request.state);
  FragilityResult result;
  result.configuration = data.configurations().at(request.configuration);
  result.state = state.name;
  result.words = state.words;
  result.measure = {measure.name, measure.units, {}};
  result.failed = data.failed(request.configuration);
  static_cast<FittedCurve&>(result) =
      fitted_curve(data, request.state, request.configuration, measure, request.method);
  result.runs = result.fit.runs;
  result.exceeded = result.fit.exceeded;
  result.records = result.fit.groups;
  const statistics::StripeTable table(result.observations);
  result.im = grid(table.stripes());
  result.band = statistics::fragility_band(table, result.im, request.confidence);
  if (table.stripes().size() <= kMaxStripes) {
    result.stripes = table.stripes();
    result.isotonic = statistics::isotonic_curve(result.stripes);
  }
  if (result.cloud) result.demand_units = units_of(state.quantity);
  if (result.by_cloud())
    judge_cloud(state.limit, request, result);
  else if (result.capacities)
    judge_capacities(request, data.study().seed, result);
  else
    judge_stripes(table, request, data.study().seed, result);
  const statistics::HazardCurve* const hazard = data.hazard_over(measure);
  if (hazard != nullptr && result.curve())
    result.rate = site_rate(*result.curve(), result.band, result.audit, *hazard);
  return result;
}

}  // namespace gurney::study
