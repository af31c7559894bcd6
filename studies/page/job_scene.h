#pragma once

#include <string>
#include <vector>

#include "engine/run/run.h"
#include "engine/scene/scene.h"
#include "studies/results/study_reader.h"

namespace gurney::page {

/// What stood where in a job, read again with the catalogue of today.
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
