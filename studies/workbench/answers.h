#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

/// Answers to the questions of a page, as JSON. Jobs are texts of docs/formats/job_file.md.
/// @throws Error with every error of a job, and its places
namespace gurney::workbench {

using Json = nlohmann::json;

/// Folder in which the texts of jobs stand for files, beside the shipped ones: paths are seen from there.
inline constexpr const char* kFolder = "/usr/share/gurney/studies/jobs/";

/// Names and descriptions of what is shipped, and the kinds of synthetic motions.
Json catalogue_answer();

/// What stands where at the start: outlines of items and room, in plan.
Json plan_answer(const std::string& job);

/// A run with its findings, as `gurney run --json` and as people read them, its limit states and the
/// recording that the player of studies/playback shows.
Json run_answer(const std::string& job);

/// Stripes of kLevels factors on the motion of the job: case i has factor i mod kLevels and draw
/// i / kLevels of every number with a distribution. A synthetic motion has another seed in each draw.
inline constexpr std::size_t kLevels = 10;
Json case_answer(const std::string& job, std::size_t index);

/// The curve of each limit state with its band.
/// @param cases  answers of case_answer()
Json fragility_answer(const Json& cases);

}  // namespace gurney::workbench
