#pragma once

#include <string>

#include "studies/analysis/stored_histories.h"
#include "studies/figures/chart.h"

namespace gurney::figures {

/// The paths of the items seen from above. Of the file of one run with the room, the outlines of
/// the items at the start and at the end, their fronts, and the points of impact; of a study the
/// paths of all runs with histories, from the start of each.
std::string trajectory_figure(const PlotPage& page, const std::string& path);

}  // namespace gurney::figures
