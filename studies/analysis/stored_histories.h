#pragma once

#include <memory>
#include <string>
#include <vector>

#include "studies/results/hdf5_reader.h"

namespace gurney::study {

/// One history of a run: a curve for each item, wheel or point, and for each axis.
struct StoredHistory {
  struct Series {
    std::string part;  ///< item, wheel or point; empty: the only item, or the floor
    std::string axis;  ///< "x", "y", "z"; empty: a number without direction
    std::vector<double> values;
  };
  std::string name;   ///< "displacement", "tilt", "normal_force"
  std::string units;  ///< SI
  std::string of;     ///< "item", "wheel", "point", or "axis" where it is of the floor
  std::vector<double> time;
  std::vector<Series> series;
};

/// The histories of a results file, of one run or of those runs of a study that keep them.
class StoredHistories {
 public:
  /// @throws Error unless it is a results file
  explicit StoredHistories(const std::string& path);
  ~StoredHistories();

  /// Names of what the file holds, in order: vectors ("displacement") and numbers ("tilt"). Empty:
  /// the file holds no histories.
  std::vector<std::string> names() const;
  std::vector<std::size_t> runs() const;  ///< those with histories

  /// @throws Error with the nearest name, or with the runs that have histories
  StoredHistory history(const std::string& name, std::size_t run) const;

  std::string title() const;
  const std::string& path() const;

 private:
  struct Layout;
  std::unique_ptr<Layout> layout_;
};

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
