#pragma once

#include <string>

#include "studies/report/comparison_report.h"

namespace gurney::figures {

/// The curves of each limit state that has one, with their bands and the shares that were seen.
std::string comparison_figure(const report::ComparisonReport& report);

}  // namespace gurney::figures
