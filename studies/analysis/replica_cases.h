#pragma once

#include <cstddef>
#include <vector>

#include "studies/results/study_reader.h"

namespace gurney::study {

/// Whether any run has a replica besides itself.
bool has_replicas(const StudyReader& file);

/// For each run the number of its case: runs of one number differ in nothing but their replica.
std::vector<std::size_t> replica_cases(const StudyReader& file);

/// For each run whether its case is chaotic: of its replicas some overturn and some do not, or the
/// peaks of displacement or tilt of an item have parted by 1 %, the bound of the verdict on single
/// runs (docs/theory/predictability.md). False without replicas.
std::vector<bool> in_chaotic_cases(const StudyReader& file);

}  // namespace gurney::study
