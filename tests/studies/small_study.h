#pragma once

#include <map>
#include <string>

#include "studies/run/run_task.h"

namespace gurney::study {

/// A trolley under a short pulse: a run of 0.2 s takes milliseconds.
/// @param study  what stands in [study] and below
inline std::string small_job(const std::string& study,
                             const std::string& motion = "kind = \"ricker\", period_s = 0.1") {
  return "schema = \"gurney-job/1\"\n"
         "title = \"Small\"\n"
         "[item]\n"
         "equipment = \"xu_trolley\"\n"
         "[excitation.record]\n"
         "synthetic = { " +
         motion +
         " }\n"
         "[settings]\n"
         "duration_s = 0.2\n"
         "settle_time_s = 0\n"
         "[study]\n" +
         study;
}

/// A study from text, with its motions and its plan.
struct SmallStudy {
  explicit SmallStudy(const std::string& text)
      : job(text, "a.toml"), motions(job), plan(job, motions) {}

  TaskResult run(std::size_t unit) const {
    return run_task(batch, unit, [] { return true; });
  }

  StudyJob job;
  StudyMotions motions;
  Plan plan;
  Batch batch{job, motions, plan};
};

}  // namespace gurney::study
