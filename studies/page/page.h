#pragma once

#include <optional>
#include <string>

#include "studies/analysis/assessment.h"
#include "studies/explanation/facts.h"
#include "studies/findings/findings.h"
#include "studies/units/unit_system.h"

namespace gurney::page {

/// What a page is asked of.
struct PageRequest {
  std::string file;  ///< of a study, of one run, or JSON of a calibration or a verification
  study::AssessmentRequest assessed_by{};  ///< of studies
  study::UnitSystem units{};
  std::string job{};  ///< where the job's file is, for names relative to it; empty: beside the file
  std::optional<explanation::Explanation> explanation{};  ///< of one run
  findings::Section narrative{};                          ///< of one run; empty: not explained
  std::string no_explanation{};                           ///< why there is none
  /// How much of a study is finished, which is still running: the page loads itself again. Empty: all
  std::string unfinished{};
};

/// The report of a results file, or of the JSON of a calibration or a verification, as one HTML page.
/// @throws Error unless it is one of these, and as StudyData does
std::string results_page(const PageRequest& request);

}  // namespace gurney::page
