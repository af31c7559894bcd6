#include "studies/exports/chosen_curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "engine/base/config/nearest_name.h"
#include "engine/base/error.h"
#include "studies/analysis/fragility_result.h"
#include "studies/limit_states/limit_state_reader.h"

namespace gurney {
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

ChosenCurves chosen_curves(const StudyData& data, const ExportChoice& choice) {
  ChosenCurves chosen{data.measure(choice.measure), {}, {}};
  const std::vector<std::size_t> states = chosen_states(data, choice);
  for (const std::size_t configuration : chosen_configurations(data, choice))
    for (const std::size_t state : states) {
      const std::vector<Observation> observations =
          data.observations(state, configuration, chosen.measure);
      const FragilityFit fit = fit_fragility(observations);
      const auto capacities = hunted_capacities(data, state, chosen.measure.name, observations);
      const std::optional<LognormalCurve> curve = capacities ? capacities->curve : fit.curve;
      const LimitState& limit = data.limit_states()[state];
      if (!curve) {
        chosen.left_out.push_back(
            fmt::format("{}{}'{}': {}", data.configurations()[configuration],
                        data.configurations()[configuration].empty() ? "" : ", ", limit.name,
                        text(capacities ? capacities->status : fit.status)));
        continue;
      }
      const auto [low, high] = std::ranges::minmax(observations, {}, &Observation::im);
      chosen.curves.push_back({data.configurations()[configuration], limit, *curve, fit.runs,
                               fit.exceeded, fit.groups, data.failed(configuration), low.im,
                               high.im});
    }
  require(!chosen.curves.empty(),
          fmt::format("{}: no fragility curve over {} can be fitted; nothing was written\n  {}",
                      data.file().path(), chosen.measure.name, fmt::join(chosen.left_out, "\n  ")));
  return chosen;
}

}  // namespace gurney
