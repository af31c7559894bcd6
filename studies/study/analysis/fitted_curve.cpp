#include "studies/study/analysis/fitted_curve.h"

#include <algorithm>

#include "engine/response/response.h"

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

CurveAudit audit_of(const StudyData& data, std::size_t configuration, const FittedCurve& fitted) {
  CurveAudit audit =
      outcome_audit(fitted.fit, fitted.observations, scale_factors(data, configuration));
  if (!fitted.capacities) return audit;
  audit.theta = {};
  if (fitted.capacities->curve) audit.theta = fitted.capacities->curve->theta;
  audit.of_capacities = true;
  const auto one_case = [](const statistics::Capacity& each) { return each.weight == 1; };
  audit.counted = std::ranges::all_of(fitted.brackets, one_case) ? "records" : "analysis cases";
  audit.outcomes = fitted.brackets.size();
  audit.exceeded = audit.outcomes - static_cast<std::size_t>(fitted.capacities->censored);
  audit.overturned = overturned(data, configuration);
  return audit;
}

}  // namespace

FittedCurve fitted_curve(const StudyData& data, std::size_t state, std::size_t configuration,
                         const RunMeasure& measure) {
  FittedCurve fitted;
  fitted.observations = data.observations(state, configuration, measure);
  fitted.fit = statistics::fit_fragility(fitted.observations);
  if (has_capacities(data, state, measure.name)) {
    fitted.brackets = statistics::ida_capacities(fitted.observations);
    fitted.capacities = statistics::fit_capacities(fitted.brackets);
  }
  fitted.audit = audit_of(data, configuration, fitted);
  return fitted;
}

}  // namespace gurney::study
