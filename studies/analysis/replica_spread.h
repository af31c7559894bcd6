#pragma once

#include <cstddef>
#include <optional>
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

/// Outcomes of the replicas of one run: the same configuration, record, angle, draw and scale.
struct ReplicaSpread {
  std::size_t runs = 0, failed = 0, overturned = 0;
  double lowest = 0, median = 0, highest = 0;  ///< peak displacement of any item [m]
};

/// None where the study has no replicas, or all of the run failed.
std::optional<ReplicaSpread> replica_spread(const StudyReader& file, std::size_t run);

}  // namespace gurney::study
