#include "studies/run/declared_ranges.h"

#include <filesystem>
#include <set>
#include <utility>

namespace gurney::study {
namespace {

using FileKeys = std::set<std::pair<std::string, std::string>>;

/// Numbers and choices that keep their values.
FileKeys kept(const Job& job) {
  FileKeys keys;
  for (const equipment::Assumption& each : job.assumptions)
    if (each.distribution.empty()) keys.emplace(each.file, each.key);
  return keys;
}

}  // namespace

DrawnJob first_job(const Batch& batch, std::size_t configuration) {
  const std::size_t draws =
      batch.job.study().draws > 0 ? batch.plan.draws(configuration) : std::size_t{0};
  for (std::size_t draw = 0; draw < draws; ++draw) {
    const Task task{.configuration = configuration, .draw = draw};
    try {
      return {draw, batch.job.job(configuration, batch.plan.draw(task))};
    } catch (const Error&) {  // its runs fail with this error
      continue;
    }
  }
  return {{}, batch.job.job(configuration, {})};
}

std::vector<StatedAssumption> stated_assumptions(const Batch& batch) {
  std::vector<StatedAssumption> all;
  for (std::size_t i = 0; i < batch.job.configurations().size(); ++i) {
    const FileKeys undrawn = kept(first_job(batch, i).job);
    for (const equipment::Assumption& each : batch.job.job(i, {}).assumptions)
      if (!each.reason.empty()) all.push_back({i, each, !undrawn.contains({each.file, each.key})});
  }
  return all;
}

UndrawnRanges undrawn_ranges(const Batch& batch) {
  UndrawnRanges ranges;
  for (const StatedAssumption& each : stated_assumptions(batch)) {
    const equipment::Assumption& number = each.assumption;
    if (!each.drawn && number.low < number.high)
      ranges.add(std::filesystem::path(number.file).filename().string(), number.key);
  }
  return ranges;
}

}  // namespace gurney::study
