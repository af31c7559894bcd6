#include "studies/exports/chosen_curves.h"

#include <fmt/format.h>

#include <optional>

#include "engine/base/error.h"
#include "engine/config/nearest_name.h"
#include "studies/limit_states/limit_state_reader.h"

namespace gurney::study {
namespace {

std::vector<std::size_t> chosen_states(const StudyData& data, const ExportChoice& choice) {
  if (!choice.limit.empty()) return {index_of(data.limit_states(), choice.limit)};
  std::vector<std::size_t> all(data.limit_states().size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  return all;
}

}  // namespace

std::vector<std::size_t> chosen_configurations(const StudyData& data, const ExportChoice& choice) {
  const std::vector<std::string>& names = data.configurations();
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (choice.configuration.empty() || names[i] == choice.configuration) chosen.push_back(i);
  require(!chosen.empty(),
          fmt::format("{}: no configuration '{}'{}", data.file().path(), choice.configuration,
                      config::suggestion(choice.configuration, names)));
  return chosen;
}

std::string basis_text(const ChosenCurve& curve) {
  const CurveAudit& of = curve.audit;
  if (of.of_demands)
    return fmt::format("the demands of {} runs with {} records (cloud)", of.outcomes,
                       curve.records);
  return of.of_capacities ? fmt::format("capacities of {} {}, of which {} exceed", of.outcomes,
                                        of.counted, of.exceeded)
                          : fmt::format("{} runs with {} records, of which {} exceed", of.outcomes,
                                        curve.records, of.exceeded);
}

std::string caution_text(const ChosenCurve& curve, const ReportUnit& unit) {
  std::string text;
  for (const std::string& each : cautions(curve.audit, unit)) text += " Caution: " + each + ".";
  return text;
}

ChosenCurves chosen_curves(const StudyData& data, const ExportChoice& choice) {
  ChosenCurves chosen{data.measure(choice.measure), {}, {}};
  const std::vector<std::size_t> states = chosen_states(data, choice);
  for (const std::size_t configuration : chosen_configurations(data, choice))
    for (const std::size_t state : states) {
      const FittedCurve fitted =
          fitted_curve(data, state, configuration, chosen.measure, choice.method);
      const std::optional<statistics::LognormalCurve> curve = fitted.curve();
      const LimitState& limit = data.limit_states()[state];
      if (!curve) {
        chosen.left_out.push_back(
            fmt::format("{}{}'{}': {}", data.configurations()[configuration],
                        data.configurations()[configuration].empty() ? "" : ", ", limit.name,
                        no_curve_text(fitted, report_unit(data, chosen.measure))));
        continue;
      }
      chosen.curves.push_back({data.configurations()[configuration], limit, *curve,
                               fitted.fit.groups, data.failed(configuration), fitted.audit});
    }
  require(!chosen.curves.empty(),
          fmt::format("{}: no fragility curve over {} can be fitted; nothing was written\n  {}",
                      data.file().path(), chosen.measure.name, fmt::join(chosen.left_out, "\n  ")));
  return chosen;
}

}  // namespace gurney::study
