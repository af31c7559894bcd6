#pragma once

#include <string>
#include <vector>

#include "studies/analysis/vector_result.h"

namespace gurney::figures {

/// A panel for each result: its runs in the plane of both measures, and where P is 16, 50 and 84 %.
std::string vector_figure(const study::StudyData& data,
                          const std::vector<study::VectorResult>& results);

}  // namespace gurney::figures
