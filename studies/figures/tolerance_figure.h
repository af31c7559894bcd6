#pragma once

#include <string>
#include <vector>

#include "studies/figures/plot_page.h"

namespace gurney::figures {

/// Checks of one kind: |error| over tolerance of each; not finite: failed.
struct ToleranceRow {
  std::string label;
  std::vector<double> used;
};

/// What part of its tolerance each check uses, on a logarithmic axis.
std::string tolerance_figure(const PlotPage& page, const std::vector<ToleranceRow>& rows);

}  // namespace gurney::figures
