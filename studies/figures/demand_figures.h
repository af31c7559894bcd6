#pragma once

#include <string>
#include <vector>

#include "studies/analysis/demand_runs.h"
#include "studies/figures/chart.h"
#include "studies/figures/panel.h"

namespace gurney::figures {

/// Figures of demands; each draws a panel, or one for each configuration, for each of `all`.

/// Curves of the cases, 16, 50 and 84 % fractiles of the demand at given intensity, and where items
/// overturn.
std::string ida_figure(const PlotPage& page, const std::string& title,
                       const std::vector<study::DemandRuns>& all);

/// The demands at each intensity, with their median and 16 and 84 % fractiles.
std::string stripes_figure(const PlotPage& page, const std::string& title,
                           const std::vector<study::DemandRuns>& all);

/// Demand over intensity, both in logarithms, with the censored regression of statistics/cloud.h.
std::string cloud_figure(const PlotPage& page, const std::string& title,
                         const std::vector<study::DemandRuns>& all);

/// Empirical distributions of the demand at each level.
std::string distribution_figure(const PlotPage& page, const std::string& title,
                                const std::vector<study::DemandRuns>& all);

std::string demand_label(const study::DemandRuns& runs);   ///< "Peak displacement (m)"
std::string measure_label(const study::DemandRuns& runs);  ///< "PGV larger (m/s)"

/// "ICU bed, off"; what is common to all panels of a figure goes without saying.
std::string panel_title(const study::DemandRuns& runs, const std::string& configuration);

/// Largest values of the runs whose item did not overturn, in the figure's unit.
double largest_demand(const study::DemandRuns& runs);
double largest_intensity(const study::DemandRuns& runs);

}  // namespace gurney::figures
