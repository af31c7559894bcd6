#include "studies/run/finished_cases.h"

#include <fmt/format.h>

#include "engine/base/error.h"
#include "studies/run/identity_file.h"
#include "studies/run/part_folder.h"
#include "studies/run/shard_folders.h"
#include "studies/run/study_file.h"
#include "studies/run/study_identity.h"

namespace gurney::study {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> folders_in(const fs::path& folder) {
  if (fs::exists(folder / "study")) return {folder};
  std::vector<fs::path> folders;
  for (const auto& [shard, path] : shards_in(folder)) folders.push_back(path);
  return folders;
}

}  // namespace

FinishedCases::FinishedCases(const fs::path& folder) {
  for (const fs::path& each : folders_in(folder)) {
    const std::string identity = IdentityFile(each).identity();
    if (identity_.empty()) {
      identity_ = identity;
      places_.resize(tasks_in(identity));
    }
    require(identity == identity_, fmt::format("{}: {} is a part of another study", folder.string(),
                                               each.filename().string()));
    take(each);
  }
}

void FinishedCases::take(const fs::path& folder) {
  const PartFormat format(identity_, places_.size());
  for (const std::uint32_t part : part_numbers(folder)) {
    const fs::path file = part_path(folder, part);
    const PartContent content = format.decode(file_bytes(file));
    damaged_ += !content.damage.empty();
    for (const PartEntry& entry : content.entries) {
      finished_ += places_.at(entry.task).file.empty();
      places_[entry.task] = {file, entry};
    }
  }
}

TaskResult FinishedCases::read(std::size_t task) const {
  const Place& place = places_.at(task);
  return task_from_bytes(PartFormat(identity_, places_.size()).read(place.file, place.entry));
}

void FinishedCases::write(const std::string& path, const std::string& job_file) const {
  const StudyJob job(job_text_in(identity_), job_file);
  const StudyMotions motions(job);
  const Plan plan(job, motions);
  const Batch batch{job, motions, plan};
  const std::string now = identity_of(batch);
  require(now == identity_,
          "the study cannot be read with what is here now: " + difference(identity_, now));
  write_study_file(
      path, batch, [this](std::size_t task) { return read(task); },
      [this](std::size_t task) { return has(task); });
}

}  // namespace gurney::study
