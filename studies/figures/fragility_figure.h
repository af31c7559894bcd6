#pragma once

#include <string>
#include <vector>

#include "studies/analysis/fragility_result.h"
#include "studies/figures/plot_page.h"

namespace gurney::figures {

/// One panel for each limit state: the curves of its configurations, their bands, and the fractions
/// of runs, or the empirical distribution of capacities.
std::string fragility_figure(const study::StudyData& data,
                             const std::vector<study::FragilityResult>& results,
                             const PlotPage& page = {});

}  // namespace gurney::figures
