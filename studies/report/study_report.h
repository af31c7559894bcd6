#pragma once

#include "studies/analysis/fragility_result.h"
#include "studies/analysis/overview.h"
#include "studies/findings/findings.h"

namespace gurney::report {

/// The median intensity of each limit state, or why there is none.
findings::List answers_of(const study::StudyOverview& overview, const study::StudyData& data,
                          const std::vector<study::FragilityResult>& fragilities);

/// The answers of a study: the median intensity of each limit state, or why there is none, and what
/// a reader has to know before any number is used.
findings::Section study_findings(const study::StudyOverview& overview, const study::StudyData& data,
                                 const std::vector<study::FragilityResult>& fragilities);

/// How often items stood in the zones of the room.
findings::Table zone_findings(const study::StudyData& data);

}  // namespace gurney::report
