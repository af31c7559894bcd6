#pragma once

#include <string>
#include <vector>

#include "studies/analysis/stored_histories.h"
#include "studies/figures/chart.h"

namespace gurney::figures {

/// A panel over time for each history. More than three wheels, points or items have axes of their
/// own, for their curves would hide each other.
std::string history_figure(const PlotPage& page, const std::string& title, const std::string& note,
                           const std::vector<study::StoredHistory>& histories);

}  // namespace gurney::figures
