#pragma once

#include <string>
#include <vector>

#include "studies/convergence/convergence.h"
#include "studies/figures/chart.h"
#include "studies/verification/verify.h"

namespace gurney::figures {

/// Each quantity that was compared all through the case, computed on reference, and beside it the
/// error. Empty where nothing was.
std::string verification_figure(const verification::CaseRun& run);

/// Change of each demand with the time step, on logarithmic axes.
std::string convergence_figure(const study::Convergence& found);

/// Checks of one kind: |error| over tolerance of each; not finite: failed.
struct ToleranceRow {
  std::string label;
  std::vector<double> used;
};

/// The part of its tolerance that each check uses, on a logarithmic axis.
std::string tolerance_figure(const PlotPage& page, const std::vector<ToleranceRow>& rows);

}  // namespace gurney::figures
