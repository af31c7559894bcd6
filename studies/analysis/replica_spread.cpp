#include "studies/analysis/replica_spread.h"

#include <algorithm>
#include <string>
#include <vector>

#include "engine/response/response.h"

namespace gurney::study {
namespace {

std::vector<std::size_t> replicas_of(const StudyReader& file, std::size_t run) {
  std::vector<std::size_t> same(file.runs());
  for (std::size_t i = 0; i < same.size(); ++i) same[i] = i;
  for (const char* column : {"configuration", "record", "angle", "draw", "scale"}) {
    const std::vector<double> values = file.numbers(std::string("runs/") + column);
    std::erase_if(same, [&](std::size_t i) { return values[i] != values[run]; });
  }
  return same;
}

}  // namespace

std::optional<ReplicaSpread> replica_spread(const StudyReader& file, std::size_t run) {
  if (!file.has_column("runs/replica")) return {};
  const std::vector<std::string> outcomes = file.strings("runs/outcome");
  const std::vector<double> of_items = file.numbers("items/peak_displacement");
  const auto rows = file.rows_of_runs("items");
  ReplicaSpread spread;
  std::vector<double> peaks;
  for (const std::size_t replica : replicas_of(file, run)) {
    ++spread.runs;
    spread.overturned += outcomes[replica] == name_of(Outcome::kOverturned);
    const auto [first, last] = rows[replica];
    if (first == last)
      ++spread.failed;
    else
      peaks.push_back(*std::max_element(of_items.begin() + static_cast<std::ptrdiff_t>(first),
                                        of_items.begin() + static_cast<std::ptrdiff_t>(last)));
  }
  if (spread.runs < 2 || peaks.empty()) return {};
  std::ranges::sort(peaks);
  spread.lowest = peaks.front();
  spread.highest = peaks.back();
  const std::size_t half = peaks.size() / 2;
  spread.median = peaks.size() % 2 == 1 ? peaks[half] : (peaks[half - 1] + peaks[half]) / 2;
  return spread;
}

}  // namespace gurney::study
