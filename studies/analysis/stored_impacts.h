#pragma once

#include <string>
#include <vector>

namespace gurney::study {

/// An impact as results files keep it.
struct StoredImpact {
  std::size_t run = 0;
  std::string item, other;  ///< other: the floor, a shape of the room or an item
  double x = 0, y = 0;      ///< of the point touched first, floor axes [m]
  double speed = 0;         ///< of the approach [m/s]
};

/// @throws Error for a file that keeps none: a study without `events` in [study.keep]
std::vector<StoredImpact> stored_impacts(const std::string& path);

/// @param runs  increasing
std::vector<StoredImpact> impacts_of_runs(const std::vector<StoredImpact>& impacts,
                                          const std::vector<std::size_t>& runs);

/// Names of the obstacles that were hit, each once, in the order of the file.
std::vector<std::string> hit_by_items(const std::vector<StoredImpact>& impacts);

}  // namespace gurney::study
