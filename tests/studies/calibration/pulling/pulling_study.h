#pragma once

#include <string>

#include "studies/results/study_reader.h"
#include "studies/run/study_file.h"
#include "tests/support/temp_folder.h"

namespace gurney::calibration {

/// Runs a job of pulling tests into `path`.
inline void run_pulling_tests(const std::string& text, const std::string& path) {
  const study::StudyJob job(text, "a.toml");
  const study::StudyMotions motions(job);
  const study::Plan plan(job, motions);
  const study::Batch batch{job, motions, plan};
  study::write_study_file(path, batch, [&](std::size_t unit) {
    return study::run_task(batch, unit, [] { return true; });
  });
}

inline std::string shipped_pulling_tests() {
  return contents_of(GURNEY_SOURCE_DIR "/studies/jobs/pulling_tests.toml");
}

/// The shipped job with other rows of `combinations`.
inline std::string pulling_tests_of(const std::string& rows) {
  std::string text = shipped_pulling_tests();
  const auto from = text.find("combinations = ["), to = text.find("\n]\n", from);
  return text.replace(from, to - from, "combinations = [\n" + rows);
}

}  // namespace gurney::calibration
