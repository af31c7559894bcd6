#include "studies/prepare/run_job.h"

#include <fmt/format.h>

#include <filesystem>

#include "engine/base/hash/sha256.h"
#include "equipment/catalogue/uncertainty.h"

namespace gurney::study {
namespace {

void append(std::vector<std::string>& list, const std::vector<std::string>& more) {
  list.insert(list.end(), more.begin(), more.end());
}

}  // namespace

AssumptionFacts facts_of(const equipment::Assumption& assumption) {
  const bool number = assumption.choice.empty();
  return {assumption.key, number ? fmt::format("{:g}", assumption.value) : assumption.choice,
          number ? fmt::format("{:g} to {:g}", assumption.low, assumption.high) : "",
          assumption.reason, std::filesystem::path(assumption.file).filename().string()};
}

PreparedRun prepare_run(const Job& job, std::optional<Motion> motion) {
  PreparedRun run;
  RunFacts& facts = run.facts;
  facts.job_name = std::filesystem::path(job.file).stem().string();
  facts.job_text = job.text;
  facts.job_sha256 = sha256(job.text);
  facts.title = job.title;
  facts.scene = job.scene;
  facts.settings = job.settings;
  facts.warnings = job.warnings;
  facts.draw = job.draw;
  for (const equipment::Assumption& each : job.assumptions) {
    if (!each.reason.empty()) facts.assumptions.push_back(facts_of(each));
    if (!each.distribution.empty())
      facts.drawn.push_back({each.key, each.value, equipment::unit_of_key(each.key),
                             each.distribution,
                             std::filesystem::path(each.file).filename().string()});
  }
  if (!motion) return run;

  facts.floor = motion->floor.with_rotation_times(job.rotation_factor);
  facts.record = std::move(motion->facts);
  facts.seed = motion->seed;
  append(facts.warnings, motion->warnings);
  return run;
}

PreparedRun prepare_run(const std::string& job_path) {
  const Job job = read_job(job_path);
  return prepare_run(job, job.record ? std::optional(motion_of(*job.record)) : std::nullopt);
}

}  // namespace gurney::study
