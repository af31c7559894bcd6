#pragma once

#include <string>
#include <vector>

#include "studies/analysis/study_data.h"

namespace gurney::study {

/// The intensities at which a study's runs were made.
struct RunLevels {
  /// As the job states them: "0.3 g", "x 1.5" for a factor. One, "all", after an IDA, which finds
  /// other intensities for each record.
  std::vector<std::string> texts;
  bool traced = false;
  std::vector<std::size_t> of_run;  ///< for each run of the file: index in texts
};

RunLevels run_levels(const StudyData& data);

}  // namespace gurney::study
