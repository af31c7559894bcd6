#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/run/run.h"
#include "engine/scene/scene.h"
#include "studies/analysis/assessment.h"
#include "studies/explanation/facts.h"
#include "studies/findings/findings.h"
#include "studies/results/study_reader.h"
#include "studies/units/unit_system.h"

namespace gurney::page {

/// Options of a page.
struct PageRequest {
  std::string file;  ///< of a study, of one run, or JSON of a calibration or a verification
  study::AssessmentRequest assessed_by{};  ///< of studies
  std::string consequences{};  ///< file of prices and what follows, of studies; empty: no losses
  study::UnitSystem units{};
  std::string job{};  ///< where the job's file is, for names relative to it; empty: beside the file
  std::optional<explanation::Explanation> explanation{};  ///< of one run
  findings::Section narrative{};                          ///< of one run; empty: not explained
  std::string no_explanation{};                           ///< why there is none
  /// How much of a study is finished, which is still running: the page loads itself again. Empty: all
  std::string unfinished{};
};

/// The report of a results file, or of the JSON of a calibration or a verification, as one HTML page.
/// @throws Error unless it is one of these, and as StudyData and Consequences do
std::string results_page(const PageRequest& request);

/// Scenes of a job, read again with the present catalogue.
struct JobScene {
  Scene scene;
  RunOptions settings;
  std::vector<std::string> changed = {};  ///< data files that are not as the study read them
};

/// The scene of the job that a results file keeps; of a study that of a
/// configuration.
/// @param job  path of the job's file, for relative names; empty: beside the results
/// @throws Error where the job names what is not there any more
JobScene scene_of_study(const study::StudyReader& file, const std::string& job,
                        std::size_t configuration = 0);
JobScene scene_of_run(const study::Hdf5Reader& file, const std::string& job);

}  // namespace gurney::page
