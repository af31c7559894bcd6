#include "studies/plan/study_motions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <functional>
#include <iterator>
#include <limits>
#include <new>
#include <utility>

#include "engine/base/append_all.h"
#include "engine/base/error.h"
#include "engine/base/parallel.h"
#include "groundmotions/assembly/plausibility.h"
#include "groundmotions/suites/suite.h"
#include "studies/job/scale_reader.h"

namespace gurney::study {
namespace {

std::size_t size_of(const groundmotions::Record& record) {
  std::size_t histories = record.rotation ? 2 : 0;
  for (const auto& component : record.components) histories += component.has_value();
  return histories * static_cast<std::size_t>(record.samples()) * sizeof(double);
}

}  // namespace

FloorRecords::Shared FloorRecords::of(const Key& key,
                                      const std::function<groundmotions::Record()>& make) {
  std::promise<Shared> promise;
  {
    std::unique_lock lock(mutex_);
    const auto found = std::ranges::find(kept_, key, &Kept::key);
    if (found != kept_.end()) {
      kept_.splice(kept_.begin(), kept_, found);
      const std::shared_future<Shared> motion = found->motion;
      lock.unlock();
      return motion.get();
    }
    kept_.push_front({key, promise.get_future().share()});
  }
  try {
    const auto made = std::make_shared<const groundmotions::Record>(make());
    promise.set_value(made);
    count(key, *made);
    return made;
  } catch (...) {
    promise.set_exception(std::current_exception());
    forget(key);
    throw;
  }
}

void FloorRecords::count(const Key& key, const groundmotions::Record& record) {
  const std::lock_guard lock(mutex_);
  const auto made = std::ranges::find(kept_, key, &Kept::key);
  made->bytes = size_of(record);
  bytes_ += made->bytes;
  for (auto last = kept_.end(); bytes_ > most_ && last != kept_.begin();) {
    --last;
    if (last->bytes == 0) continue;
    bytes_ -= last->bytes;
    last = kept_.erase(last);
  }
}

void FloorRecords::forget(const Key& key) {
  const std::lock_guard lock(mutex_);
  std::erase_if(kept_, [&](const Kept& each) { return each.key == key; });
}

namespace {

/// The floor motions that are kept, in bytes: ten levels of a record of 300 s with 200 samples a
/// second, five times over.
constexpr std::size_t kKeptFloors = 128 << 20;

/// A tree as text: two trees that are read alike have the same.
void write(const config::Node& node, std::string& text) {
  if (node.elements.empty()) text += describe(node);
  for (const config::Node& each : node.elements) {
    text += each.key + '{';
    write(each, text);
    text += '}';
  }
}

std::string excitation_text(const config::Node& job) {
  std::string text;
  if (const config::Node* excitation = job.find("excitation")) write(*excitation, text);
  return text;
}

std::string text_of(const std::exception_ptr& problem) {
  if (!problem) return "";
  try {
    std::rethrow_exception(problem);
  } catch (const std::bad_alloc&) {
    return "not enough memory for the records";
  } catch (const std::exception& error) {
    return error.what();
  }
}

groundmotions::Suite suite_of(const RecordRequest& request,
                              const std::vector<std::filesystem::path>& paths) {
  groundmotions::Suite suite = groundmotions::read_suite(paths, request.options);
  std::string refused;
  for (const groundmotions::Refusal& each : suite.refused)
    refused += fmt::format("{}{}: {}", refused.empty() ? "" : "\n", request.where,
                           groundmotions::text_of(each));
  require(refused.empty(), refused);
  require(!suite.records.empty(), request.where + ": the suite has no records");
  return suite;
}

/// SHA-256 and name of each file of a record, one a line.
std::string files_of(const groundmotions::Record& record) {
  std::string text;
  for (const auto& component : record.components) {
    if (!component || component->sha256.empty()) continue;
    const std::string line = fmt::format(
        "{} {}", component->sha256, std::filesystem::path(component->file).filename().string());
    if (text.find(line) == std::string::npos) text += (text.empty() ? "" : "\n") + line;
  }
  return text;
}

double or_none(const std::function<double()>& value) {
  try {
    return value();
  } catch (const Error&) {
    return std::numeric_limits<double>::quiet_NaN();
  }
}

}  // namespace

MotionSet::MotionSet(const Job& job, const Study& study, FloorRecords& floors, std::size_t index)
    : request_(job.record),
      intensity_(study.intensity),
      kept_(study.measures),
      floors_(floors),
      index_(index) {
  if (!request_) {
    names_ = {""};
  } else if (study.synthetic_records > 0) {
    for (int seed = 1; seed <= study.synthetic_records; ++seed)
      names_.push_back(fmt::format("{} {}", request_->synthetic->kind->name, seed));
  } else {
    read_suites();
    if (suite_.empty()) names_ = {study::ground_record(*request_).name};
  }
  slots_ = std::make_unique<Slot[]>(names_.size());
}

void MotionSet::read_suites() {
  const auto add = [&](const std::vector<std::filesystem::path>& paths, const std::string& suffix) {
    groundmotions::Suite suite = suite_of(*request_, paths);
    for (const groundmotions::SuiteRecord& record : suite.records)
      names_.push_back(record.name + suffix);
    std::ranges::move(suite.records, std::back_inserter(suite_));
    std::ranges::move(suite.notes, std::back_inserter(notes_));
    std::ranges::move(suite.warnings, std::back_inserter(notes_));
  };
  if (!request_->suite_by_level) {
    if (!request_->suite.empty()) add(request_->suite, "");
    return;
  }
  for (std::size_t level = 0; level < intensity_.levels.size(); ++level) {
    add({request_->suite[level]},
        fmt::format(" at {:g} {}", intensity_.levels[level] / intensity_.unit_in_si,
                    intensity_.unit));
    level_of_.resize(suite_.size(), level);
  }
}

groundmotions::SourceFacts MotionSet::source_of(const groundmotions::Record& record,
                                                std::size_t index) const {
  std::vector<groundmotions::NamedFacts> sources;
  if (!suite_.empty()) sources.push_back(suite_[index].facts);
  for (const auto& component : record.components)
    if (component) sources.push_back(component->header);
  return groundmotions::source_facts(sources);
}

const GroundMotion& MotionSet::ground(std::size_t record) const {
  Slot& slot = slots_[record];
  std::call_once(slot.once, [&] {
    const auto motion = is_synthetic()
                            ? ground_record(record)
                            : std::make_shared<const groundmotions::Record>(read(record));
    slot.motion = facts_of(record, *motion);
    if (!is_synthetic()) slot.record = motion;
  });
  return slot.motion;
}

FloorRecords::Shared MotionSet::ground_record(std::size_t record) const {
  constexpr double kGround = 0;  // no floor has it as scale
  if (is_synthetic()) return floors_.of({index_, record, kGround}, [&] { return read(record); });
  ground(record);
  return slots_[record].record;
}

groundmotions::Record MotionSet::read(std::size_t record) const {
  if (!request_) return {};
  RecordRequest request = *request_;
  const double scale = stated_scale(record);
  request.suite.clear();
  if (!suite_.empty()) {
    request.files = suite_[record].files;
    request.options = suite_[record].options;
  } else if (names_.size() > 1) {
    request.synthetic->values["seed"] = static_cast<double>(record + 1);
  }
  groundmotions::Record motion = study::ground_record(request);
  motion.name = names_[record];
  if (request.scale_to) motion = scaled_to(motion, *request.scale_to);
  if (scale != 1) motion = groundmotions::scaled(std::move(motion), scale);
  return motion;
}

void MotionSet::add_tables(const groundmotions::Record& motion, GroundMotion& facts) const {
  const groundmotions::FloorTables& tables = *request_->building->building.tables;
  require(
      tables.proportional || !scaled_by_measure(),
      fmt::format("{}: study.intensity scales the records, but the tables are those of the records "
                  "as they are: only floors that move in proportion to the ground (`proportional = "
                  "true`) can follow",
                  tables.where));
  for (const double scale : scaled_by_measure() ? std::vector<double>{1} : intensity_.levels) {
    const groundmotions::Record floor = floor_record_of(
        scale == 1 ? motion : groundmotions::scaled(motion, scale, intensity_.vertical), *request_);
    for (const auto& [path, sum] : floor.floor_files) {
      const std::string line =
          fmt::format("{} {}", sum, std::filesystem::path(path).filename().string());
      if (facts.files.find(line) == std::string::npos)
        facts.files += (facts.files.empty() ? "" : "\n") + line;
    }
  }
}

GroundMotion MotionSet::facts_of(std::size_t record, const groundmotions::Record& motion) const {
  GroundMotion facts;
  if (!request_) {
    facts.measures.assign(kept_.size(), std::numeric_limits<double>::quiet_NaN());
    return facts;
  }
  facts.files = files_of(motion);
  facts.processing = motion.processing;
  facts.duration = motion.time_step() * static_cast<double>(motion.samples());
  facts.source = source_of(motion, record);
  facts.record_warnings = facts.warnings = motion.warnings;
  if (record == 0) append_all(facts.warnings, notes_);
  const std::vector<std::string> findings = implausible(motion);
  require(!request_->refuse_implausible || findings.empty(),
          fmt::format("{}: record '{}' is not plausible, and plausibility = \"refuse\":\n{}",
                      request_->where, names_[record], fmt::join(findings, "\n")));
  append_all(facts.warnings, findings);
  for (const KeptMeasure& kept : kept_)
    facts.measures.push_back(
        or_none([&] { return value_of(kept.measure, kept.combination, motion); }));
  if (request_->building && request_->building->building.tables) add_tables(motion, facts);
  if (!scaled_by_measure()) return facts;
  try {
    facts.intensity = value_of(intensity_.measure, intensity_.combination, motion);
  } catch (const Error& error) {
    throw Error(request_->where + ": " + error.what());
  }
  require(facts.intensity > 0,
          fmt::format("{}: record '{}' cannot be scaled: its {} is {:g}", request_->where,
                      names_[record], name_of(intensity_.measure), facts.intensity));
  return facts;
}

std::vector<double> MotionSet::levels(std::size_t record) const {
  if (!level_of_.empty()) return {intensity_.levels[level_of_[record]]};
  if (intensity_.kind != IntensityPlan::Kind::kIda) return intensity_.levels;
  std::vector<double> values{intensity_.first};
  for (std::size_t step = 1; step < kStepsOfIda; ++step)
    values.push_back(values.back() + static_cast<double>(step) * intensity_.increment);
  return values;
}

double MotionSet::stated_scale(std::size_t record) const {
  return (request_ ? request_->scale : 1) * (suite_.empty() ? 1 : suite_[record].scale);
}

double MotionSet::scale_for(std::size_t record, double value) const {
  return std::pow(value / ground(record).intensity,
                  1 / groundmotions::scaling_power(intensity_.measure));
}

FloorRecords::Shared MotionSet::floor_record(std::size_t record, double scale) const {
  const auto make = [&] {
    const FloorRecords::Shared ground = ground_record(record);
    return floor_record_of(
        scale == 1 ? *ground : groundmotions::scaled(*ground, scale, intensity_.vertical),
        *request_);
  };
  if (request_->building) return floors_.of({index_, record, scale}, make);
  return std::make_shared<const groundmotions::Record>(make());
}

FloorMotion MotionSet::floor(std::size_t record, double scale, double angle,
                             std::vector<std::string>& warnings) const {
  if (!request_) return {};
  const FloorRecords::Shared floor = floor_record(record, scale);
  const std::vector<std::string>& of_ground = ground(record).record_warnings;
  for (const std::string& warning : floor->warnings)
    if (std::ranges::find(of_ground, warning) == of_ground.end()) warnings.push_back(warning);
  return in_floor_axes(*floor, *request_, request_->angle + angle);
}

std::optional<Motion> MotionSet::motion(std::size_t record, double scale, double angle) const {
  if (!request_) return {};
  return as_motion(*floor_record(record, scale), *request_, request_->angle + angle);
}

StudyMotions::StudyMotions(const StudyJob& job)
    : floors_(std::make_unique<FloorRecords>(kKeptFloors)) {
  const config::FileSnapshot::Scope scope(job.files());
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < job.configurations().size(); ++i) {
    const std::string text = excitation_text(job.configurations()[i].tree);
    std::size_t found = 0;
    while (found < texts.size() && texts[found] != text) ++found;
    if (found == texts.size()) {
      texts.push_back(text);
      sets_.push_back(
          std::make_unique<MotionSet>(job.job(i, {}), job.study(), *floors_, sets_.size()));
    }
    of_configuration_.push_back(found);
  }
}

void StudyMotions::read_all(int threads) const {
  std::vector<std::pair<const MotionSet*, std::size_t>> all;
  for (const auto& set : sets_)
    for (std::size_t i = 0; i < set->size(); ++i) all.emplace_back(set.get(), i);
  std::vector<std::exception_ptr> problems(all.size());
  parallel_for(all.size(), threads, [&](std::size_t i) {
    try {
      all[i].first->ground(all[i].second);
    } catch (...) {  // without memory, not even its text can be kept
      problems[i] = std::current_exception();
    }
  });
  std::string text;
  for (const std::exception_ptr& problem : problems) {
    const std::string each = text_of(problem);
    if (!each.empty() && text.find(each) == std::string::npos)
      text += (text.empty() ? "" : "\n") + each;
  }
  require(text.empty(), text);
}

}  // namespace gurney::study
