#pragma once

#include <string>
#include <vector>

#include "studies/analysis/fragility_result.h"
#include "studies/figures/chart.h"
#include "studies/report/comparison_report.h"

namespace gurney::figures {

/// One panel for each limit state: the curves of its configurations, their bands, and the fractions
/// of runs, or the empirical distribution of capacities.
std::string fragility_figure(const study::StudyData& data,
                             const std::vector<study::FragilityResult>& results,
                             const PlotPage& page = {});

/// The curves of each limit state that has one, with their bands and the shares that were seen.
std::string comparison_figure(const report::ComparisonReport& report);

/// A panel for each result: its runs in the plane of both measures, and where P is 16, 50 and 84 %.
std::string vector_figure(const study::StudyData& data,
                          const std::vector<study::VectorResult>& results);

}  // namespace gurney::figures
