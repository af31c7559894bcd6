#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "studies/report/narrative.h"
#include "studies/report/settled.h"
#include "studies/report/words.h"
#include "studies/results/names.h"

namespace gurney::report {
namespace {

/// "front left: peak normal force"
std::string demand_name(const DemandNumber& number, const EquipmentModel& model) {
  std::string name = study::part_of(number, model);
  if (!name.empty()) name += ": ";
  name += number.name;
  std::ranges::replace(name, '_', ' ');
  return name;
}

/// Why a demand is not settled.
std::string reason(const SettledDemand& demand) {
  if (!std::isfinite(demand.step_change)) return "comes or goes";
  if (SettledDemand::kMargin * std::abs(demand.step_change) > SettledDemand::kFractions[3])
    return fmt::format("{:+.2g} %", 100 * demand.step_change);
  if (!demand.predictable()) return "by the change of mass";
  return demand.number.counts_events() ? "as many at half the step" : "others change by more";
}

/// "40 are settled within 1 % and 3 within 5 %"
std::string counts(const std::vector<SettledDemand>& all) {
  std::vector<std::string> texts;
  for (const double fraction : SettledDemand::kFractions) {
    const auto count = std::ranges::count(all, fraction, &SettledDemand::within);
    if (count > 0) texts.push_back(fmt::format("{} within {:g} %", count, 100 * fraction));
  }
  return texts.empty() ? "none" : listed(texts);
}

/// Those of the item and of its marked points by name, those of wheels by number.
std::string unsettled(const std::vector<SettledDemand>& all, const EquipmentModel& model) {
  std::vector<std::string> texts;
  std::size_t of_wheels = 0;
  for (const SettledDemand& each : all) {
    if (each.settled()) continue;
    if (each.number.of == DemandNumber::Of::kWheel)
      ++of_wheels;
    else
      texts.push_back(fmt::format("{} ({})", demand_name(each.number, model), reason(each)));
  }
  if (of_wheels > 0)
    texts.push_back(fmt::format("{} number{} of wheels", of_wheels, of_wheels == 1 ? "" : "s"));
  return texts.empty() ? "" : "; NOT SETTLED: " + listed(texts);
}

}  // namespace

std::string within_text(const SettledDemand& demand) {
  return demand.settled() ? fmt::format("{:g} %", 100 * demand.within()) : "no";
}

const SettledDemand* find_settled(const std::vector<SettledDemand>& all, DemandNumber::Of of,
                                  std::size_t part, const char* name) {
  const auto found = std::ranges::find_if(all, [&](const SettledDemand& each) {
    return each.number.of == of && each.number.part == part &&
           each.number.name == std::string_view(name);
  });
  return found == all.end() ? nullptr : &*found;
}

std::string narrative_of_settled(const study::RunFacts& facts, const Response& response) {
  const std::vector<std::string> names = study::item_names(facts.scene);
  const bool several = names.size() > 1;
  std::string text;
  for (std::size_t i = 0; i < response.items.size(); ++i) {
    const std::vector<SettledDemand> all = settled_demands(response.items[i]);
    if (all.empty()) continue;
    text += fmt::format("{}, of {} demands: {}{}{}\n", several ? "  " + names[i] : "Settled",
                        all.size(), counts(all), unsettled(all, facts.scene.items.at(i).model),
                        several ? "" : ".");
  }
  return several && !text.empty() ? "Settled\n" + text : text;
}

}  // namespace gurney::report
