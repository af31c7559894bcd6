#include "studies/analysis/stored_impacts.h"

#include <algorithm>

#include "studies/results/hdf5_reader.h"

namespace gurney::study {

std::vector<StoredImpact> stored_impacts(const std::string& path) {
  const Hdf5Reader file(path);
  const auto datasets = file.datasets();
  require(std::ranges::find(datasets, "/events/run", &Hdf5Dataset::path) != datasets.end(),
          path + ": keeps no impacts (study.keep.events)");
  const auto run = file.numbers("/events/run"), x = file.numbers("/events/point_x"),
             y = file.numbers("/events/point_y"), speed = file.numbers("/events/approach_speed");
  const auto item = file.strings("/events/item"), other = file.strings("/events/other");
  file.require_length({"/events/point_x", "/events/point_y", "/events/approach_speed",
                       "/events/item", "/events/other"},
                      run.size());
  std::vector<StoredImpact> impacts;
  for (std::size_t i = 0; i < run.size(); ++i)
    impacts.push_back({static_cast<std::size_t>(run[i]), item[i], other[i], x[i], y[i], speed[i]});
  return impacts;
}

std::vector<StoredImpact> impacts_of_runs(const std::vector<StoredImpact>& impacts,
                                          const std::vector<std::size_t>& runs) {
  std::vector<StoredImpact> of_runs;
  std::ranges::copy_if(impacts, std::back_inserter(of_runs), [&](const StoredImpact& each) {
    return std::ranges::binary_search(runs, each.run);
  });
  return of_runs;
}

std::vector<std::string> hit_by_items(const std::vector<StoredImpact>& impacts) {
  std::vector<std::string> names;
  for (const StoredImpact& each : impacts)
    if (std::ranges::find(names, each.other) == names.end()) names.push_back(each.other);
  return names;
}

}  // namespace gurney::study
