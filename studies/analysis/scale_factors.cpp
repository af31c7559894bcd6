#include "studies/analysis/scale_factors.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace gurney::study {
namespace {

/// Nothing shakes where every name is empty.
bool has_records(const StudyData& data) {
  if (!data.file().has("records")) return true;
  return std::ranges::any_of(data.file().strings("records/name"),
                             [](const std::string& name) { return !name.empty(); });
}

}  // namespace

void ScaleFactors::add(std::size_t record, double factor) {
  auto& [low, high] = of_record_.try_emplace(record, factor, factor).first->second;
  low = std::min(low, factor);
  high = std::max(high, factor);
}

double ScaleFactors::lowest() const {
  double low = std::numeric_limits<double>::infinity();
  for (const auto& [record, factors] : of_record_) low = std::min(low, factors.first);
  return low;
}

double ScaleFactors::highest() const {
  double high = 0;
  for (const auto& [record, factors] : of_record_) high = std::max(high, factors.second);
  return high;
}

std::size_t ScaleFactors::above() const {
  return static_cast<std::size_t>(std::ranges::count_if(
      of_record_, [](const auto& each) { return each.second.second > kLargestFactor; }));
}

std::size_t ScaleFactors::below() const {
  return static_cast<std::size_t>(std::ranges::count_if(
      of_record_, [](const auto& each) { return each.second.first < kSmallestFactor; }));
}

std::string ScaleFactors::text() const {
  std::string text = fmt::format("{:.3g} to {:.3g}; {} of {} records above {:g}", lowest(),
                                 highest(), above(), records(), kLargestFactor);
  return below() == 0 ? text : text + fmt::format(", {} below {:g}", below(), kSmallestFactor);
}

ScaleFactors scale_factors(const StudyData& data, std::size_t configuration) {
  ScaleFactors factors;
  if (!has_records(data)) return factors;
  const std::vector<double> scales = data.factors_on_records();
  for (const std::size_t run : data.runs_of(configuration))
    factors.add(data.record_of(run), scales[run]);
  return factors;
}

ScaleFactors scale_factors(const StudyData& data) {
  ScaleFactors factors;
  if (!has_records(data)) return factors;
  const std::vector<double> scales = data.factors_on_records();
  for (std::size_t run = 0; run < scales.size(); ++run) factors.add(data.row_of(run), scales[run]);
  return factors;
}

}  // namespace gurney::study
