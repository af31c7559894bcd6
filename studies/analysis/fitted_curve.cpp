#include "studies/analysis/fitted_curve.h"

#include <algorithm>

#include "engine/response/response.h"
#include "studies/statistics/capacity.h"

namespace gurney::study {
namespace {

bool has_capacities(const StudyData& data, std::size_t state, const std::string& measure) {
  return data.ends_ida(state) && measure == data.file().text_attribute("intensity_measure");
}

std::size_t overturned(const StudyData& data, std::size_t configuration) {
  const std::vector<std::string> outcomes = data.file().strings("runs/outcome");
  return static_cast<std::size_t>(std::ranges::count_if(
      data.runs_of(configuration),
      [&](std::size_t run) { return outcomes[run] == name_of(Outcome::kOverturned); }));
}

CurveAudit audit_of(const StudyData& data, std::size_t state, std::size_t configuration,
                    const FittedCurve& fitted) {
  CurveAudit audit =
      outcome_audit(fitted.fit, fitted.observations, scale_factors(data, configuration));
  // A cloud takes them as at least at the limit.
  if (!fitted.by_cloud()) audit.overturned_short = data.overturned_short_of(state, configuration);
  audit.theta = {};
  if (fitted.by_cloud()) {
    audit.of_demands = true;
    if (fitted.cloud_curve) audit.theta = fitted.cloud_curve->theta;
    audit.effective = statistics::effective_groups(fitted.demands);
    return audit;
  }
  if (fitted.fit.curve) audit.theta = fitted.fit.curve->theta;
  if (!fitted.capacities) return audit;
  audit.theta = {};
  if (fitted.capacities->curve) audit.theta = fitted.capacities->curve->theta;
  audit.of_capacities = true;
  const auto one_case = [](const statistics::Capacity& each) { return each.weight == 1; };
  audit.counted = std::ranges::all_of(fitted.brackets, one_case) ? "records" : "analysis cases";
  audit.outcomes = fitted.brackets.size();
  audit.exceeded = audit.outcomes - static_cast<std::size_t>(fitted.capacities->censored);
  audit.overturned = overturned(data, configuration);
  audit.fewest = statistics::kFewestCapacities;
  if (audit.theta)
    audit.effective = statistics::effective_capacities(fitted.brackets, *fitted.capacities);
  return audit;
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
  if (!fitted.by_cloud()) return no_curve_text(fitted.status(), fitted.median(), unit);
  if (!fitted.cloud) return "a cloud needs one demand above a limit";
  if (fitted.cloud->status != statistics::CloudStatus::kFitted) return text(fitted.cloud->status);
  return "the demand increases hardly or not with intensity, or its limit is far beyond the runs";
}

FittedCurve fitted_curve(const StudyData& data, std::size_t state, std::size_t configuration,
                         const RunMeasure& measure, CurveMethod method) {
  FittedCurve fitted;
  fitted.method = method;
  fitted.observations = data.observations(state, configuration, measure);
  fitted.fit = statistics::fit_fragility(fitted.observations);
  if (has_capacities(data, state, measure.name)) {
    fitted.brackets = statistics::ida_capacities(fitted.observations);
    fitted.capacities = statistics::fit_capacities(fitted.brackets);
  }
  add_cloud(data, state, configuration, measure, fitted);
  fitted.audit = audit_of(data, state, configuration, fitted);
  return fitted;
}

}  // namespace gurney::study
