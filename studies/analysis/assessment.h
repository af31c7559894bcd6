#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/plan/assessment_files.h"
#include "studies/plan/study.h"
#include "studies/results/study_reader.h"

namespace gurney::study {

/// Criteria that replace those of a study's job. Empty: as the job states.
struct AssessmentRequest {
  std::vector<std::string> limit_states = {};  ///< lines as of read_limit_state_expression()
  std::string limit_states_file = {};          ///< with performance levels; its states come first
  std::string hazard_file = {};

  bool empty() const {
    return limit_states.empty() && limit_states_file.empty() && hazard_file.empty();
  }
};

/// Criteria by which a study is assessed.
struct Assessment {
  std::vector<LimitState> limit_states;
  std::vector<std::size_t> performance;  ///< limit states, mildest first
  std::optional<SiteHazard> hazard;
};

/// The one place that decides which limit states, performance levels and hazard apply. Limit states
/// that are given replace those of the job; performance levels of the job go with its limit states.
/// @throws Error with all errors, and for what the file does not hold
Assessment assessment_of(const StudyReader& file, const Study& job,
                         const AssessmentRequest& request);

}  // namespace gurney::study
