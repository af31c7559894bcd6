#pragma once

#include <string>
#include <vector>

#include "studies/analysis/suite_spectra.h"
#include "studies/figures/chart.h"

namespace gurney::figures {

/// The spectra of a suite with their median, 16 and 84 % fractiles: of the records as they are, of
/// the records scaled to the level, and of the building's floor under these.
/// @param what  "records", "scaled", "floor"; empty: all there are
/// @throws Error for other words, and for floors of a study without building
std::string spectra_figure(const PlotPage& page, const std::string& title,
                           const std::vector<study::SuiteSpectra>& suites,
                           const std::vector<std::string>& what = {});

std::string floor_spectra_figure(const PlotPage& page, const std::string& title,
                                 const study::FloorSpectra& spectra);

}  // namespace gurney::figures
