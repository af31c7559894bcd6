#pragma once

#include <string>
#include <vector>

#include "studies/analysis/fragility_result.h"
#include "studies/figures/chart.h"
#include "studies/report/comparison_report.h"
#include "studies/report/study_report.h"

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

/// Indices with their intervals, and beside them the tornado.
std::string sensitivity_figure(const report::SensitivityReport& report);

/// A tornado for each report: means of the output over the runs in which an input is low, and over
/// those in which it is high; the longest bars above.
std::string tornado_figure(const PlotPage& page, const std::string& title,
                           const std::vector<report::SensitivityReport>& reports);

}  // namespace gurney::figures
