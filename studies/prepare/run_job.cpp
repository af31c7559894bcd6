#include "studies/prepare/run_job.h"

#include <fmt/format.h>

#include <filesystem>

#include "engine/base/append_all.h"
#include "engine/base/error.h"
#include "engine/base/hash/sha256.h"
#include "engine/base/input_file.h"
#include "engine/base/units.h"
#include "equipment/catalogue/uncertainty.h"
#include "groundmotions/assembly/plausibility.h"
#include "groundmotions/buildings/floor_record.h"
#include "groundmotions/measures/peaks.h"
#include "groundmotions/processing/pipeline.h"
#include "groundmotions/record/record_motion.h"
#include "studies/job/scale_reader.h"

namespace gurney::study {
namespace {

/// The components to use: those the record has and the job does not switch off.
std::vector<groundmotions::Direction> used_components(const groundmotions::Record& record,
                                                      const RecordRequest& request) {
  static constexpr std::array kAxes = {"x", "y", "z"};
  const std::array wanted = {request.use_x, request.use_y, request.use_z};
  std::vector<groundmotions::Direction> use;
  std::string missing, there;
  for (const groundmotions::Direction direction : groundmotions::kDirections) {
    const auto axis = static_cast<std::size_t>(direction);
    if (record[direction]) there += kAxes[axis];
    if (!wanted[axis]) continue;
    if (record[direction])
      use.push_back(direction);
    else
      missing +=
          fmt::format("{}{} ({})", missing.empty() ? "" : ", ", kAxes[axis], name_of(direction));
  }
  require(request.use_stated || missing.empty(),
          fmt::format("{}: record '{}' has no {} component; state with use = \"{}\" that "
                      "the others act",
                      request.where, record.name, missing, there));
  require(!use.empty(),
          fmt::format("{}: use: none of these components is in record '{}', which has {}",
                      request.where, record.name, there));
  return use;
}

/// Which component of which file acts where.
std::vector<std::string> components_of(const groundmotions::Record& record) {
  std::vector<std::string> lines;
  for (const groundmotions::Direction direction : groundmotions::kDirections) {
    if (!record[direction]) continue;
    const groundmotions::Component& c = *record[direction];
    std::string line = fmt::format("{}: '{}'", name_of(direction), c.name);
    if (!c.file.empty())
      line += fmt::format(" of {}", std::filesystem::path(c.file).filename().string());
    if (c.azimuth) line += fmt::format(", azimuth {:.0f} deg", *c.azimuth / kRadiansPerDegree);
    lines.push_back(line);
  }
  return lines;
}

/// Peaks and residuals are those of the floor's motion: scaled, turned, in floor axes.
RecordFacts facts_of(const groundmotions::Record& record, const FloorMotion& floor,
                     const groundmotions::Residual& left) {
  RecordFacts facts;
  facts.name = record.name;
  for (const auto& component : record.components) {
    if (!component || component->sha256.empty()) continue;
    const FileFacts file{std::filesystem::path(component->file).filename().string(),
                         component->sha256};
    const bool known = !facts.files.empty() && facts.files.back().name == file.name &&
                       facts.files.back().sha256 == file.sha256;
    if (!known) facts.files.push_back(file);  // one file may hold several components
  }
  for (const auto& [path, sum] : record.floor_files)
    facts.files.push_back({std::filesystem::path(path).filename().string(), sum});
  facts.components = components_of(record);
  facts.processing = record.processing;
  facts.duration = floor.duration();
  facts.time_step = floor.time_step();
  for (int axis = 0; axis < 3; ++axis) {
    const groundmotions::Peaks largest =
        groundmotions::peaks(floor.time_step(), floor.acceleration().row(axis).transpose());
    facts.pga[axis] = largest.acceleration;
    facts.pgv[axis] = largest.velocity;
    facts.pgd[axis] = largest.displacement;
  }
  facts.residual_velocity = left.velocity;
  facts.residual_displacement = left.displacement;
  return facts;
}

/// A synthetic motion with its kind and all parameters as the first line of its processing.
groundmotions::Record made(const groundmotions::SyntheticRequest& request) {
  groundmotions::Record record = groundmotions::make_record(request);
  std::string line = "made: " + request.kind->name;
  for (const auto& [key, value] : request.values) line += fmt::format(", {} = {:g}", key, value);
  record.processing.insert(record.processing.begin(), line);
  return record;
}

/// Adds the place in the job to what goes wrong.
template <class Work>
groundmotions::Record at(const std::string& where, Work work) {
  try {
    return work();
  } catch (const Error& error) {
    throw Error(where + ": " + error.what());
  }
}

/// Components that the record lacks, found although no unit is stated; empty: none.
std::string missing_beside_unit(const RecordRequest& request) {
  groundmotions::ReadOptions any_unit = request.options;
  any_unit.unit = "m/s2";
  groundmotions::Record record;
  try {
    record = groundmotions::read_record(request.files, any_unit);
  } catch (const Error&) {
    return {};  // what is wrong besides the unit is stated already
  }
  try {
    used_components(record, request);
    return {};
  } catch (const Error& error) {
    return std::string("\n") + error.what();
  }
}

groundmotions::Record read(const RecordRequest& request) {
  try {
    return groundmotions::read_record(request.files, request.options);
  } catch (const Error& error) {
    if (!request.options.unit.empty()) throw Error(request.where + ": " + error.what());
    throw Error(error.what() + missing_beside_unit(request));
  }
}

/// Read or made, and processed.
groundmotions::Record unscaled(const RecordRequest& request) {
  groundmotions::Record record = request.synthetic ? made(*request.synthetic) : read(request);
  return at(request.where,
            [&] { return groundmotions::processed(std::move(record), request.processing); });
}

std::optional<std::uint64_t> seed_of(const RecordRequest& request) {
  if (!request.synthetic) return {};
  const auto found = request.synthetic->values.find("seed");
  if (found == request.synthetic->values.end()) return {};
  return static_cast<std::uint64_t>(found->second);
}

void add_building_file(const RecordRequest& request, RecordFacts& facts) {
  if (!request.building || request.building->file.empty()) return;
  const std::filesystem::path path = request.building->file;
  facts.files.push_back({path.filename().string(), sha256(read_input_file(path.string()))});
}

/// @throws Error for a motion beyond what a record file may hold
void check_amplitude(const FloorMotion& floor, const std::string& where) {
  constexpr double kLargest = 100 * kStandardGravity;  // of a record file too
  const double peak = floor.acceleration().cwiseAbs().maxCoeff();
  require(peak <= kLargest,
          fmt::format(
              "{}: the motion of the floor has a peak of {:.3g} g after scaling; at most {:g} g "
              "are allowed: check scale or scale_to",
              where, peak / kStandardGravity, kLargest / kStandardGravity));
}

groundmotions::Record scaled_as_asked(groundmotions::Record record, const RecordRequest& request) {
  if (request.scale_to)
    return at(request.where, [&] { return scaled_to(record, *request.scale_to); });
  return request.scale == 1 ? record : groundmotions::scaled(std::move(record), request.scale);
}

groundmotions::Record through_building(groundmotions::Record ground, const RecordRequest& request) {
  if (!request.building) return ground;
  const BuildingRequest& asked = *request.building;
  return groundmotions::floor_record(ground, asked.building, asked.floor, asked.place);
}

}  // namespace

groundmotions::Record ground_record(const RecordRequest& request) {
  require(request.suite.empty(), request.where +
                                     ": a suite belongs to jobs with a table [study]; one run has "
                                     "one record: 'file', or 'x', 'y', 'z', or 'synthetic'");
  return unscaled(request);
}

groundmotions::Record floor_record_of(const groundmotions::Record& ground,
                                      const RecordRequest& request) {
  return through_building(ground, request);
}

FloorMotion in_floor_axes(const groundmotions::Record& floor, const RecordRequest& request,
                          double angle) {
  return groundmotions::floor_motion(floor, 1, angle, used_components(floor, request));
}

Motion as_motion(const groundmotions::Record& floor, const RecordRequest& request, double angle) {
  Motion motion;
  motion.floor = in_floor_axes(floor, request, angle);
  const groundmotions::Residual left = groundmotions::residual(motion.floor);
  motion.facts = facts_of(floor, motion.floor, left);
  motion.seed = seed_of(request);
  add_building_file(request, motion.facts);
  motion.warnings = floor.warnings;
  append_all(motion.warnings, left.warnings);
  return motion;
}

Motion motion_of(const RecordRequest& request) {
  return motion_of(ground_record(request), request);
}

Motion motion_of(const groundmotions::Record& raw, const RecordRequest& request) {
  const groundmotions::Record record = floor_record_of(scaled_as_asked(raw, request), request);
  Motion motion = as_motion(record, request, request.angle);
  check_amplitude(motion.floor, request.where);
  const std::vector<std::string> findings = implausible(raw);
  std::vector<std::string> faults = findings;
  const groundmotions::Residual left = groundmotions::residual(motion.floor);
  append_all(faults, left.warnings);
  require(!request.refuse_implausible || faults.empty(),
          fmt::format("{}: the record is not plausible, and plausibility = \"refuse\":\n{}",
                      request.where, fmt::join(faults, "\n")));
  motion.warnings.insert(
      motion.warnings.begin() + static_cast<std::ptrdiff_t>(record.warnings.size()),
      findings.begin(), findings.end());
  return motion;
}

std::optional<Motion> motion_of(const Job& job) {
  return job.record ? std::optional(motion_of(*job.record)) : std::nullopt;
}

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
    if (!each.in_use) continue;
    if (!each.reason.empty()) facts.assumptions.push_back(facts_of(each));
    if (!each.distribution.empty())
      facts.drawn.push_back({each.key, each.value, equipment::unit_of_key(each.key),
                             each.distribution,
                             std::filesystem::path(each.file).filename().string()});
  }
  if (!motion) return run;

  facts.floor = motion->floor.with_rocking_times(job.rotation_factor);
  facts.record = std::move(motion->facts);
  facts.seed = motion->seed;
  append_all(facts.warnings, motion->warnings);
  return run;
}

PreparedRun prepare_run(const std::string& job_path) {
  const Job job = read_job(job_path);
  return prepare_run(job, motion_of(job));
}

}  // namespace gurney::study
