#include "studies/analysis/demand_runs.h"

#include <algorithm>
#include <cmath>

#include "engine/base/error.h"
#include "studies/analysis/run_levels.h"

namespace gurney::study {
namespace {

std::string item_of(const NamedDemand& demand) {
  const Quantity& of = demand.quantity;
  return of.part.empty() ? of.item : of.item + "/" + of.part;
}

DemandRuns& place_for(std::vector<DemandRuns>& all, const DemandRuns& wanted) {
  for (DemandRuns& each : all)
    if (each.item == wanted.item && each.column == wanted.column) return each;
  all.push_back(wanted);
  return all.back();
}

}  // namespace

std::vector<DemandRuns> demand_runs(const StudyData& data,
                                    const std::vector<std::size_t>& configurations,
                                    const std::string& demand, const RunMeasure& measure) {
  std::vector<DemandRuns> all;
  const RunLevels levels = run_levels(data);
  const std::vector<double> cases = data.file().numbers("runs/analysis_case");
  for (const std::size_t configuration : configurations)
    for (const NamedDemand& named : demands_named(data, configuration, {demand})) {
      const std::vector<std::size_t>& runs = data.runs_of(configuration);
      const std::vector<double> values = values_of_runs(data, named, runs);
      const NamedDemand fall{
          "", "s", {Quantity::Of::kItem, "time_of_overturning", named.quantity.item, ""}};
      const std::vector<double> falls = values_of_runs(data, fall, runs);
      DemandRuns::Configuration found{data.configurations()[configuration], {}};
      for (std::size_t i = 0; i < runs.size(); ++i) {
        const std::size_t run = runs[i];
        if (!std::isfinite(values[i]) || !(measure.values[run] > 0)) continue;
        found.runs.push_back({measure.values[run], values[i], falls[i] >= 0, data.record_of(run),
                              static_cast<std::size_t>(cases[run]),
                              levels.texts[levels.of_run[run]], run});
      }
      if (found.runs.empty()) continue;
      const DemandRuns place{item_of(named), named.quantity.column, data.units().of(named.units),
                             measure.name, report_unit(data, measure)};
      place_for(all, place).configurations.push_back(std::move(found));
    }
  require(!all.empty(), data.file().path() + ": no run has " + demand + " and " + measure.name);
  return all;
}

}  // namespace gurney::study
