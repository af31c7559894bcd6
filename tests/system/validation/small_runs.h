#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "studies/run/run_task.h"

namespace gurney::study {

/// Single tasks of a study of studies/jobs, made as in the whole study.
class SmallRuns {
 public:
  using Levels = std::map<std::string, std::string>;  ///< factor and level

  explicit SmallRuns(const std::string& name)
      : job_(GURNEY_SOURCE_DIR "/studies/jobs/" + name + ".toml"),
        motions_(job_),
        plan_(job_, motions_) {}

  /// The same of a changed text.
  /// @param path  for messages and relative names
  SmallRuns(const std::string& text, const std::string& path)
      : job_(text, path), motions_(job_), plan_(job_, motions_) {}

  std::size_t count() const { return plan_.tasks() * plan_.runs_of_task(); }

  /// The runs of the first `records` records with these levels, angle by angle.
  std::vector<StudyRun> runs(const Levels& levels, std::size_t records = 1) const {
    std::vector<StudyRun> result;
    for (std::size_t index = 0; index < plan_.tasks(); ++index) {
      const Task task = plan_.task(index);
      if (task.record >= records || !has(task.configuration, levels)) continue;
      for (StudyRun& run : run_task(batch(), index, [] { return true; }).runs) {
        if (is_failure(run.response.outcome))
          throw std::runtime_error(fmt::format("unit {}: diverged: {}", index, run.response.cause));
        result.push_back(std::move(run));
      }
    }
    if (result.empty()) throw std::logic_error("no unit has these levels");
    return result;
  }

  /// What simulate() gets for the first record with these levels.
  RunCase first_case(const Levels& levels, double scale) const {
    for (std::size_t index = 0; index < plan_.tasks(); ++index) {
      const Task task = plan_.task(index);
      if (has(task.configuration, levels))
        return case_of(batch(), task, job_.job(task.configuration, plan_.draw(task)), scale);
    }
    throw std::logic_error("no unit has these levels");
  }

 private:
  Batch batch() const { return {job_, motions_, plan_}; }

  bool has(std::size_t configuration, const Levels& levels) const {
    const auto& factors = job_.study().factors;
    return std::ranges::all_of(levels, [&](const auto& wanted) {
      for (std::size_t i = 0; i < factors.size(); ++i)
        if (factors[i].name == wanted.first)
          return job_.configurations()[configuration].levels[i] == wanted.second;
      throw std::logic_error("no factor " + wanted.first);
    });
  }

  StudyJob job_;
  StudyMotions motions_;
  Plan plan_;
};

inline const Demands& demands_of(const StudyRun& run) { return run.response.items.at(0).demands; }

inline bool fell(const StudyRun& run) { return demands_of(run).time_of_overturning >= 0; }

}  // namespace gurney::study
