#pragma once

#include <cstddef>
#include <string>

#include "engine/response/response.h"
#include "studies/plan/study_job.h"
#include "studies/prepare/run_job.h"
#include "studies/results/study_reader.h"

namespace gurney::cli {

/// One case of a finished study, to be run again.
class StudyCase {
 public:
  /// @param job  the job's file; empty: where the study's log says it was
  /// @throws Error where the file has no such run, or the job is not that of the study
  StudyCase(const std::string& path, std::size_t run, const std::string& job);

  const std::string& job() const { return job_; }
  study::PreparedRun prepared() const;

  /// What differs from the demands in the file, and what may be why; empty: nothing.
  std::string difference(const Response& response) const;

 private:
  study::StudyReader file_;
  std::size_t run_;
  std::string job_;
  study::StudyJob study_;
};

}  // namespace gurney::cli
