#pragma once

#include <string>
#include <vector>

#include "studies/study/analysis/vector_result.h"

namespace gurney::report {

/// A row for each configuration and limit state: slopes of both measures, whether the second adds
/// to the first, and beta beside those of each alone.
std::string vector_report(const study::StudyData& data,
                          const std::vector<study::VectorResult>& results);

/// The same for machines, in SI; no fit: null.
std::string vector_json(const std::vector<study::VectorResult>& results);

/// A panel for each result: its runs in the plane of both measures, and where P is 16, 50 and 84 %.
std::string vector_figure(const study::StudyData& data,
                          const std::vector<study::VectorResult>& results);

}  // namespace gurney::report
