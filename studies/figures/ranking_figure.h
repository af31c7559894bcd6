#pragma once

#include <string>

#include "studies/analysis/record_ranking.h"
#include "studies/analysis/stored_histories.h"
#include "studies/analysis/suite_spectra.h"
#include "studies/figures/chart.h"

namespace gurney::figures {

/// Spectra of the motions below the item and its paths, in the colours of their order: the record
/// with the largest demand is the darkest. Paths are those of the runs with histories.
std::string ranking_figure(const PlotPage& page, const study::RecordRanking& ranking,
                           const study::SuiteSpectra& spectra,
                           const study::StoredHistories& histories);

}  // namespace gurney::figures
