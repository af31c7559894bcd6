#include "studies/analysis/vector_result.h"

#include <fmt/format.h>

#include "engine/base/error.h"
#include "studies/statistics/cloud.h"

namespace gurney::study {

VectorResult vector_of(const StudyData& data, std::size_t state, std::size_t configuration,
                       const MeasurePair& measures) {
  VectorResult result;
  result.configuration = data.configurations().at(configuration);
  result.state = data.limit_states().at(state).name;
  result.words = data.limit_states()[state].words;
  result.failed = data.failed(configuration);
  result.measures = {data.measure(measures[0]), data.measure(measures[1])};
  require(result.measures[0].name != result.measures[1].name,
          fmt::format("{}: the second measure must not be the first, {}", data.file().path(),
                      result.measures[0].name));
  const std::vector<std::size_t>& runs = data.runs_of(configuration);
  const std::vector<bool> exceeds = data.exceedances(state, runs);
  std::array<std::vector<statistics::Observation>, 2> alone;
  std::vector<statistics::CloudPoint> points;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const double first = result.measures[0].values[runs[i]];
    const double second = result.measures[1].values[runs[i]];
    if (!(first > 0 && second > 0)) {
      ++result.left_out;
      continue;
    }
    const std::size_t record = data.record_of(runs[i]);
    result.runs.push_back({first, second, exceeds[i], record});
    points.push_back({.im = first, .edp = second, .group = record});
    alone[0].push_back({first, exceeds[i], record});
    alone[1].push_back({second, exceeds[i], record});
  }
  result.fit = statistics::fit_vector(result.runs);
  if (result.fit.status == statistics::VectorStatus::kFitted)
    result.audit.theta = result.audit.lowest = result.audit.highest = result.fit.theta();
  result.audit.outcomes = result.fit.runs;
  result.audit.exceeded = result.fit.exceeded;
  result.audit.records = result.fit.groups;
  result.audit.effective = statistics::effective_groups(points);
  result.audit.fewest = statistics::kFewestGroups;
  result.audit.factors = scale_factors(data, configuration);
  for (const std::size_t i : {0, 1}) result.alone[i] = statistics::fit_fragility(alone[i]);
  return result;
}

}  // namespace gurney::study
