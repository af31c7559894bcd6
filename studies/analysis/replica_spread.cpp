#include "studies/analysis/replica_spread.h"

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <vector>

#include "engine/base/units.h"
#include "engine/response/response.h"
#include "studies/statistics/quantiles.h"

namespace gurney::study {
namespace {

constexpr double kParted = 0.01;

/// A peak of an item, and what counts as rest.
struct Peak {
  const char* column;
  double rest;
};
constexpr std::array<Peak, 2> kPeaks = {
    {{"items/peak_displacement", 1e-3}, {"items/peak_tilt", 0.1 * kRadiansPerDegree}}};

/// Smallest and largest of what the replicas of a case did.
struct Extent {
  double low = 0, high = 0;
  bool any = false;
  void add(double value) {
    low = any ? std::min(low, value) : value;
    high = any ? std::max(high, value) : value;
    any = true;
  }
};

}  // namespace

bool has_replicas(const StudyReader& file) {
  return file.has_column("runs/replica") &&
         std::ranges::any_of(file.numbers("runs/replica"), [](double k) { return k > 0; });
}

std::vector<std::size_t> replica_cases(const StudyReader& file) {
  constexpr std::array<const char*, 5> kColumns = {"configuration", "record", "angle", "draw",
                                                   "scale"};
  std::vector<std::array<double, kColumns.size()>> keys(file.runs());
  for (std::size_t c = 0; c < kColumns.size(); ++c) {
    const std::string column = std::string("runs/") + kColumns[c];
    if (!file.has_column(column)) continue;
    const std::vector<double> values = file.numbers(column);
    for (std::size_t run = 0; run < keys.size(); ++run) keys[run][c] = values[run];
  }
  std::map<std::array<double, kColumns.size()>, std::size_t> number;
  std::vector<std::size_t> cases;
  for (const auto& key : keys)
    cases.push_back(number.try_emplace(key, number.size()).first->second);
  return cases;
}

std::vector<bool> in_chaotic_cases(const StudyReader& file) {
  std::vector<bool> chaotic(file.runs(), false);
  if (!has_replicas(file)) return chaotic;
  const std::vector<std::size_t> cases = replica_cases(file);
  std::vector<bool> case_is_chaotic(file.runs(), false);
  const auto rows = file.rows_of_runs("items");
  for (const Peak& peak : kPeaks) {
    const std::vector<double> values = file.numbers(peak.column);
    std::map<std::pair<std::size_t, std::size_t>, Extent> extents;  // of a case and an item
    for (std::size_t run = 0; run < cases.size(); ++run)
      for (std::size_t row = rows[run].first; row < rows[run].second; ++row)
        extents[{cases[run], row - rows[run].first}].add(values[row]);
    for (const auto& [key, extent] : extents)
      if (extent.high - extent.low > kParted * std::max(extent.high, peak.rest))
        case_is_chaotic[key.first] = true;
  }
  std::map<std::size_t, Extent> fell;
  const std::vector<std::string> outcomes = file.strings("runs/outcome");
  for (std::size_t run = 0; run < cases.size(); ++run)
    fell[cases[run]].add(outcomes[run] == name_of(Outcome::kOverturned));
  for (const auto& [key, extent] : fell)
    if (extent.low < extent.high) case_is_chaotic[key] = true;
  for (std::size_t run = 0; run < cases.size(); ++run) chaotic[run] = case_is_chaotic[cases[run]];
  return chaotic;
}

std::optional<ReplicaSpread> replica_spread(const StudyReader& file, std::size_t run) {
  if (!file.has_column("runs/replica")) return {};
  const std::vector<std::string> outcomes = file.strings("runs/outcome");
  const std::vector<double> of_items = file.numbers("items/peak_displacement");
  const auto rows = file.rows_of_runs("items");
  ReplicaSpread spread;
  std::vector<double> peaks;
  const std::vector<std::size_t> cases = replica_cases(file);
  for (std::size_t replica = 0; replica < cases.size(); ++replica) {
    if (cases[replica] != cases[run]) continue;
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
  spread.lowest = std::ranges::min(peaks);
  spread.highest = std::ranges::max(peaks);
  spread.median = statistics::quantile_of(peaks, 0.5);
  return spread;
}

}  // namespace gurney::study
