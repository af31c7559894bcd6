#pragma once

#include <string>
#include <vector>

#include "studies/figures/chart.h"
#include "studies/report/sensitivity_report.h"

namespace gurney::figures {

/// Indices with their intervals, and beside them the tornado.
std::string sensitivity_figure(const report::SensitivityReport& report);

/// A tornado for each report: means of the output over the runs in which an input is low, and over
/// those in which it is high; the longest bars above.
std::string tornado_figure(const PlotPage& page, const std::string& title,
                           const std::vector<report::SensitivityReport>& reports);

}  // namespace gurney::figures
