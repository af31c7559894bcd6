#include "studies/analysis/fitted_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "engine/response/response.h"
#include "studies/statistics/capacity.h"

namespace gurney::study {
namespace {

std::size_t overturned(const StudyData& data, std::size_t configuration) {
  const std::vector<std::string> outcomes = data.file().strings("runs/outcome");
  return static_cast<std::size_t>(std::ranges::count_if(
      data.runs_of(configuration),
      [&](std::size_t run) { return outcomes[run] == name_of(Outcome::kOverturned); }));
}

void audit_capacities(const StudyData& data, std::size_t configuration, FittedCurve& fitted) {
  CurveAudit& audit = fitted.audit;
  audit.theta = {};
  if (fitted.capacities->curve) audit.theta = fitted.capacities->curve->theta;
  audit_brackets(data, configuration, fitted.brackets, audit);
  audit.effective =
      audit.theta ? statistics::effective_capacities(fitted.brackets, *fitted.capacities) : 0;
}

void audit_cloud(FittedCurve& fitted) {
  CurveAudit& audit = fitted.audit;
  audit.of_demands = true;
  audit.theta = {};
  if (fitted.cloud_curve) audit.theta = fitted.cloud_curve->theta;
  audit.effective = statistics::effective_groups(fitted.demands);
}

void add_cloud(const StudyData& data, std::size_t state_index, std::size_t configuration,
               const RunMeasure& measure, FittedCurve& fitted) {
  const LimitState& state = data.limit_states().at(state_index);
  if (state.kind != LimitState::Kind::kAbove || state.at_least > 1 || !(state.limit > 0)) return;
  fitted.demands = data.cloud(state_index, configuration, measure, kFloorOfLimit * state.limit);
  fitted.cloud = statistics::fit_cloud(fitted.demands);
  const auto fragility = statistics::cloud_fragility(*fitted.cloud, state.limit);
  if (!fragility) return;
  const auto [low, high] = std::ranges::minmax(fitted.demands, {}, &statistics::CloudPoint::im);
  const double theta = fragility->curve.theta;
  if (theta * statistics::kFarthestEnd >= low.im && theta <= high.im * statistics::kFarthestEnd) {
    fitted.cloud_curve = fragility->curve;
    fitted.cloud_covariance = fragility->covariance;
  }
}

}  // namespace

std::string no_curve_text(const FittedCurve& fitted, const ReportUnit& unit) {
  if (!fitted.by_cloud()) {
    const std::string known = median_text(fitted.median, unit);
    return outcomes_text(fitted.status(), fitted.change(), unit) +
           (known.empty() ? "" : ": " + known);
  }
  if (!fitted.cloud) return "a cloud needs one demand above a limit";
  if (fitted.cloud->status != statistics::CloudStatus::kFitted) return text(fitted.cloud->status);
  return "the demand increases hardly or not with intensity, or its limit is far beyond the runs";
}

FittedCurve fitted_curve(const StudyData& data, std::size_t state, std::size_t configuration,
                         const RunMeasure& measure, CurveMethod method) {
  const std::vector<statistics::Observation> observations =
      data.observations(state, configuration, measure);
  FittedCurve fitted;
  if (method == CurveMethod::kOwn) {
    fitted = curve_of_event(data, configuration, measure, observations);
    fitted.audit.overturned_short = data.overturned_short_of(state, configuration);
  } else {  // a cloud takes them as at least at the limit
    fitted.method = method;
    fitted.observations = observations;
    fitted.fit = statistics::fit_fragility(observations);
    fitted.audit = outcome_audit(fitted.fit, observations, scale_factors(data, configuration));
  }
  add_cloud(data, state, configuration, measure, fitted);
  if (fitted.by_cloud()) audit_cloud(fitted);
  return fitted;
}

FittedCurve curve_of_event(const StudyData& data, std::size_t configuration,
                           const RunMeasure& measure,
                           std::vector<statistics::Observation> observations) {
  FittedCurve fitted;
  fitted.observations = std::move(observations);
  fitted.fit = statistics::fit_fragility(fitted.observations);
  fitted.audit = outcome_audit(fitted.fit, fitted.observations, scale_factors(data, configuration));
  if (data.traces(configuration, measure)) {
    fitted.brackets = statistics::ida_capacities(fitted.observations);
    fitted.capacities = statistics::fit_capacities(fitted.brackets);
    audit_capacities(data, configuration, fitted);
  } else {
    fitted.audit.chosen_by_response = data.is_ida();
  }
  if (!fitted.curve())
    fitted.median = statistics::median_bounds(statistics::StripeTable(fitted.observations));
  return fitted;
}

void audit_brackets(const StudyData& data, std::size_t configuration,
                    const std::vector<statistics::Capacity>& brackets, CurveAudit& audit) {
  audit.of_capacities = true;
  const auto one_case = [](const statistics::Capacity& each) { return each.weight == 1; };
  audit.counted = std::ranges::all_of(brackets, one_case) ? "records" : "analysis cases";
  audit.outcomes = brackets.size();
  const auto number_of = [&](auto holds) {
    return static_cast<std::size_t>(std::ranges::count_if(brackets, holds));
  };
  const auto censored = [](const statistics::Capacity& each) { return std::isinf(each.high); };
  audit.exceeded = audit.outcomes - number_of(censored);
  audit.overturned = overturned(data, configuration);
  const std::set<std::size_t> ended = data.ended_cases(configuration);
  audit.ended = number_of([&](const statistics::Capacity& each) {
    return censored(each) && ended.contains(each.analysis_case);
  });
  audit.fewest = statistics::kFewestCapacities;
}

statistics::FragilityBand band_of_curve(const FittedCurve& fitted, const std::vector<double>& im,
                                        double confidence) {
  if (!fitted.capacities || !fitted.capacities->curve)
    return statistics::fragility_band(statistics::StripeTable(fitted.observations), im, confidence);
  statistics::FragilityBand band;
  band.status = fitted.capacities->status;
  band.effective = fitted.audit.effective;
  band.too_few = has_few_records(fitted.audit);
  band.theta = band.beta = {0, std::numeric_limits<double>::infinity()};
  if (band.too_few) return band;
  const double beta = fitted.capacities->curve->beta;
  statistics::CapacityIntervals intervals =
      statistics::capacity_intervals(fitted.brackets, *fitted.capacities, im, confidence);
  band.of_curve = std::move(intervals.of_curve);
  band.theta = statistics::bounded(intervals.theta, fitted.audit.lowest, fitted.audit.highest);
  band.beta = statistics::bounded(intervals.beta, beta, beta);
  band.outline = std::move(intervals.outline);
  return band;
}

}  // namespace gurney::study
