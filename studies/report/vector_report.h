#pragma once

#include <vector>

#include "studies/analysis/vector_result.h"
#include "studies/findings/findings.h"

namespace gurney::report {

/// For each configuration and limit state the slopes of both measures, whether the second adds to
/// the first, and beta beside those of each alone. JSON is in SI unless units are chosen; no fit:
/// its plane is null.
findings::Section vector_findings(const study::StudyData& data,
                                  const std::vector<study::VectorResult>& results);

}  // namespace gurney::report
