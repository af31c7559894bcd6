#include "studies/figures/demand_axes.h"

#include <algorithm>

#include "studies/figures/labels.h"

namespace gurney::figures {

std::string demand_label(const study::DemandRuns& runs) {
  return with_unit(label_of(runs.column), runs.unit);
}

std::string measure_label(const study::DemandRuns& runs) {
  return with_unit(label_of(runs.measure), runs.measure_unit);
}

std::string panel_title(const study::DemandRuns& runs, const std::string& configuration) {
  return configuration.empty() ? runs.item : runs.item + ", " + configuration;
}

double largest_demand(const study::DemandRuns& runs) {
  double largest = 0;
  for (const auto& configuration : runs.configurations)
    for (const study::DemandRun& run : configuration.runs)
      if (!run.overturned) largest = std::max(largest, run.demand / runs.unit.in_si);
  return largest > 0 ? largest : 1;
}

double largest_intensity(const study::DemandRuns& runs) {
  double largest = 0;
  for (const auto& configuration : runs.configurations)
    for (const study::DemandRun& run : configuration.runs)
      largest = std::max(largest, run.im / runs.measure_unit.in_si);
  return largest;
}

}  // namespace gurney::figures
