#pragma once

#include <string>
#include <vector>

#include "studies/analysis/vector_result.h"

namespace gurney::report {

/// A row for each configuration and limit state: slopes of both measures, whether the second adds
/// to the first, and beta beside those of each alone.
std::string vector_report(const study::StudyData& data,
                          const std::vector<study::VectorResult>& results);

/// The same for machines, in SI unless units are chosen; no fit: null.
std::string vector_json(const std::vector<study::VectorResult>& results,
                        const study::UnitSystem& units = {});

}  // namespace gurney::report
