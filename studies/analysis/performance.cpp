#include "studies/analysis/performance.h"

#include <algorithm>

namespace gurney::study {
namespace {

const FragilityResult* find(const std::vector<FragilityResult>& results, const std::string& state,
                            const std::string& configuration) {
  for (const FragilityResult& each : results)
    if (each.state == state && each.configuration == configuration) return &each;
  return nullptr;
}

double probability(const FragilityResult& result, std::size_t stripe) {
  if (const auto curve = result.curve()) return curve->probability(result.stripes[stripe].im);
  return result.isotonic[stripe];
}

/// How much more likely a worse level is than a milder one, at most.
double crossing(const std::vector<double>& exceedance) {
  double largest = 0;
  for (std::size_t i = 1; i < exceedance.size(); ++i)
    largest = std::max(largest, exceedance[i] - exceedance[i - 1]);
  return largest;
}

constexpr double kSmallCrossing = 0.005;  // what a table in per cent does not show

}  // namespace

std::vector<PerformanceTable> performance_tables(const StudyData& data,
                                                 const std::vector<FragilityResult>& results) {
  std::vector<PerformanceTable> tables;
  for (const std::string& configuration : data.configurations()) {
    PerformanceTable table{configuration, {}, {}, {}};
    std::vector<const FragilityResult*> of_levels;
    for (const std::size_t state : data.performance()) {
      const std::string& name = data.limit_states()[state].name;
      const FragilityResult* const found = find(results, name, configuration);
      if (found == nullptr || found->stripes.empty()) break;
      table.levels.push_back(name);
      of_levels.push_back(found);
    }
    if (of_levels.empty() || of_levels.size() < data.performance().size()) continue;
    for (std::size_t i = 0; i < of_levels.front()->stripes.size(); ++i) {
      std::vector<double> exceedance;
      for (const FragilityResult* level : of_levels) exceedance.push_back(probability(*level, i));
      table.im.push_back(of_levels.front()->stripes[i].im);
      table.at.push_back(statistics::level_probabilities(exceedance));
      table.at.back().crossed = crossing(exceedance) > kSmallCrossing;
    }
    tables.push_back(std::move(table));
  }
  return tables;
}

}  // namespace gurney::study
