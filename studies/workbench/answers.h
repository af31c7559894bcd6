#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

/// Answers to the questions of a page, as JSON. Jobs are texts of docs/formats/job_file.md.
/// @throws Error with every error of a job, and its places
namespace gurney::workbench {

using Json = nlohmann::json;

/// Folder in which the texts of jobs stand for files, beside the shipped ones: paths are seen from there.
inline constexpr const char* kFolder = "/usr/share/gurney/studies/jobs/";
inline const std::string kJob = std::string(kFolder) + "job.toml";

/// Files have changed: what was read of them counts no more.
void forget_files();

/// Tables of two straps that hold an item of the job from its front and its back.
Json straps_answer(const std::string& job, std::size_t item);

/// Names and descriptions of what is shipped, and the kinds of synthetic motions.
Json catalogue_answer();

/// Plan at the start: outlines of items and room, and tethers; and the storeys of the building.
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

/// The text of an item that a job names, and the name of its file.
Json source_answer(const std::string& equipment);

/// What the file of an item describes: where its shapes, casters and centres of mass are, what holds it up,
/// and what `gurney equipment show` says of it.
/// Answer on a file with errors: these, and the places of its values.
/// @param name  of the file, as a job names it
Json item_answer(const std::string& name, const std::string& text);

/// Changes of the job that might have prevented what befell an item, as keys of its text: those variants of
/// `gurney explain --what-if` that a job can state, other coverings, casters turned.
Json alternatives_answer(const std::string& job);

/// What a job leads to, without repetitions.
/// @param replica  number of replica_of(); 0: the job as it is
Json outcome_answer(const std::string& job, std::size_t replica);

}  // namespace gurney::workbench
