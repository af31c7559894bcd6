#pragma once

#include <string>

#include "studies/analysis/demand_runs.h"
#include "studies/figures/panel.h"

namespace gurney::figures {

std::string demand_label(const study::DemandRuns& runs);   ///< "Peak displacement (m)"
std::string measure_label(const study::DemandRuns& runs);  ///< "PGV larger (m/s)"

/// "ICU bed, off"; what is common to all panels of a figure goes without saying.
std::string panel_title(const study::DemandRuns& runs, const std::string& configuration);

/// Of the runs whose item did not overturn, in the figure's unit.
double largest_demand(const study::DemandRuns& runs);
double largest_intensity(const study::DemandRuns& runs);

}  // namespace gurney::figures
