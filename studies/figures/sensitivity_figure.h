#pragma once

#include <string>

#include "studies/report/sensitivity_report.h"

namespace gurney::figures {

/// Indices with their intervals, and beside them the tornado.
std::string sensitivity_figure(const report::SensitivityReport& report);

}  // namespace gurney::figures
