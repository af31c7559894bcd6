#include "studies/run_job.h"

#include <fmt/format.h>

#include <filesystem>

#include "engine/base/error.h"
#include "engine/base/hash/sha256.h"
#include "groundmotions/measures/peaks.h"
#include "groundmotions/record_motion.h"
#include "groundmotions/record_set.h"
#include "groundmotions/residual.h"
#include "studies/job/job.h"

namespace gurney {
namespace {

Record read_record_of(const RecordRequest& request) {
  std::vector<RecordFile> files;
  if (!request.x.empty()) files.push_back({request.x, Direction::kH1});
  if (!request.y.empty()) files.push_back({request.y, Direction::kH2});
  if (!request.z.empty()) files.push_back({request.z, Direction::kVertical});
  if (!request.file.empty()) files.push_back({request.file, std::nullopt});
  return read_record(files, {.unit = request.units, .time_step = request.time_step});
}

/// The components to use: those the record has and the job does not switch off.
std::vector<Direction> used_components(const Record& record, const RecordRequest& request) {
  std::vector<Direction> use;
  if (record[Direction::kH1] && request.use_x) use.push_back(Direction::kH1);
  if (record[Direction::kH2] && request.use_y) use.push_back(Direction::kH2);
  if (record[Direction::kVertical] && request.use_z) use.push_back(Direction::kVertical);
  require(!use.empty(), request.where + ": none of the record's components acts");
  return use;
}

/// Peaks and residuals are those of the floor's motion: scaled, turned, in floor axes.
RecordFacts facts_of(const Record& record, const FloorMotion& floor, const Residual& left) {
  RecordFacts facts;
  facts.name = record.name;
  for (const auto& component : record.components) {
    if (!component) continue;
    const FileFacts file{std::filesystem::path(component->file).filename().string(),
                         component->sha256};
    const bool known = !facts.files.empty() && facts.files.back().name == file.name &&
                       facts.files.back().sha256 == file.sha256;
    if (!known) facts.files.push_back(file);  // one file may hold several components
  }
  facts.duration = floor.duration();
  facts.time_step = floor.time_step();
  for (int axis = 0; axis < 3; ++axis) {
    const Peaks largest = peaks(floor.time_step(), floor.acceleration().row(axis).transpose());
    facts.pga[axis] = largest.acceleration;
    facts.pgv[axis] = largest.velocity;
    facts.pgd[axis] = largest.displacement;
  }
  facts.residual_velocity = left.velocity;
  facts.residual_displacement = left.displacement;
  return facts;
}

AssumptionFacts facts_of(const Assumption& assumption) {
  const bool number = assumption.choice.empty();
  return {assumption.key, number ? fmt::format("{:g}", assumption.value) : assumption.choice,
          number ? fmt::format("{:g} to {:g}", assumption.low, assumption.high) : "",
          assumption.reason, std::filesystem::path(assumption.file).filename().string()};
}

void append(std::vector<std::string>& list, const std::vector<std::string>& more) {
  list.insert(list.end(), more.begin(), more.end());
}

}  // namespace

PreparedRun prepare_run(const std::string& job_path) {
  const Job job = read_job(job_path);
  PreparedRun run{.facts = {}, .excitation = job.excitation};
  RunFacts& facts = run.facts;
  facts.job_name = std::filesystem::path(job_path).stem().string();
  facts.job_text = job.text;
  facts.job_sha256 = sha256(job.text);
  facts.title = job.title;
  facts.scene = job.scene;
  facts.settings = job.settings;
  facts.warnings = job.warnings;
  for (const Assumption& assumption : job.assumptions)
    facts.assumptions.push_back(facts_of(assumption));
  if (!job.record) return run;

  const Record record = read_record_of(*job.record);
  run.excitation.floor = floor_motion(record, job.record->scale, job.record->angle,
                                      used_components(record, *job.record));
  const Residual left = residual(run.excitation.floor);
  facts.record = facts_of(record, run.excitation.floor, left);
  append(facts.warnings, record.warnings);
  append(facts.warnings, left.warnings);
  return run;
}

}  // namespace gurney
