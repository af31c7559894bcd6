#pragma once

#include "studies/analysis/fragility_result.h"
#include "studies/analysis/overview.h"
#include "studies/findings/findings.h"

namespace gurney::report {

/// The median intensity of each limit state, or why there is none.
findings::List answers_of(const study::StudyOverview& overview, const study::StudyData& data,
                          const std::vector<study::FragilityResult>& fragilities);

/// Which of two configurations exceeds the limit states less often, and how sure that is; empty
/// where there are not two that share runs.
findings::List compared_answers(const study::StudyOverview& overview,
                                const study::StudyData& data);

/// What a reader has to know before any number of a study is used.
findings::Texts cautions_of(const study::StudyOverview& overview, const study::StudyData& data,
                            const std::vector<study::FragilityResult>& fragilities);

/// How often items stood in the zones of the room.
findings::Table zone_findings(const study::StudyData& data);

}  // namespace gurney::report
