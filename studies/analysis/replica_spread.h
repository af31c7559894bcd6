#pragma once

#include <cstddef>
#include <optional>

#include "studies/results/study_reader.h"

namespace gurney::study {

/// What the replicas of one run did: of the same configuration, record, angle, draw and scale.
struct ReplicaSpread {
  std::size_t runs = 0, failed = 0, overturned = 0;
  double lowest = 0, median = 0, highest = 0;  ///< peak displacement of any item [m]
};

/// None where the study has no replicas, or all of the run failed.
std::optional<ReplicaSpread> replica_spread(const StudyReader& file, std::size_t run);

}  // namespace gurney::study
