#pragma once

#include "studies/analysis/record_ranking.h"
#include "studies/findings/findings.h"

namespace gurney::report {

/// One ranking: which measure explains the order, and each record with what it predicts.
findings::Section ranking_findings(const study::StudyData& data,
                                   const study::RecordRanking& ranking);

}  // namespace gurney::report
