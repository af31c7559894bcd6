#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/response/response.h"
#include "studies/explanation/facts.h"
#include "studies/plan/study_job.h"
#include "studies/prepare/run_job.h"
#include "studies/render/render.h"
#include "studies/results/study_reader.h"
#include "studies/run/shard_status.h"

namespace gurney::cli {

/// The job file that the log beside a results file names last, from the folder where it ran unless it
/// is found from here; empty: none.
std::string job_of_log(const std::string& results);

/// The job file that a folder of shards names; empty: none.
std::string job_of_shards(const std::filesystem::path& folder);

/// The results that the folder FILE.h5.parts, or FILE.h5.shards, will become.
std::string results_of_folder(const std::string& folder);

/// The job of a study in such a folder: as named, or else where the folder or the log beside the results
/// says it was.
/// @throws Error where the named one is that of another study
std::string job_of_unfinished(const study::FinishedCases& cases, const std::string& folder,
                              const std::string& named);

/// Message on the job of results where nothing has its path: "does not exist any more", or why
/// the system cannot look for it.
std::string why_not_there(const std::string& path);

/// One case of a finished study, to be run again.
class StudyCase {
 public:
  /// @param job  the job's file; empty: where the study's log says it was
  /// @throws Error where the file has no such run, or the job is not that of the study
  StudyCase(const std::string& path, std::size_t run, const std::string& job);

  const std::string& job() const { return job_; }
  study::PreparedRun prepared() const;

  /// Difference to the demands in the file, with its probable cause; empty: none.
  std::string difference(const Response& response) const;

 private:
  study::StudyReader file_;
  std::size_t run_;
  std::string job_;
  study::StudyJob study_;
};

/// Whether an HDF5 file holds a study. @throws Error unless it is one
bool is_study(const std::string& path);

/// The run of a results file, to be run again: the one of a single run, or one of a study.
struct RepeatedRun {
  study::PreparedRun run;
  /// Difference to the demands in the file, with its probable cause; empty: none.
  std::function<std::string(const Response&)> difference;
  /// Predictability as the file of a single run states it, whatever the spacing of histories here.
  std::vector<std::pair<std::string, Predictability>> predictability = {};
};

/// @param index  the run of a study; of a single run none or 0
/// @param job  the job's file; empty: where the log beside the file says it was
/// @throws Error where the file has no such run, or the job is not that of the file
RepeatedRun repeated_run(const std::string& file, std::optional<std::size_t> index,
                         const std::string& job);

/// Why a run ended as it did, and what happened in it.
struct Explained {
  explanation::Explanation explanation;
  findings::Section narrative;
};

/// Runs the case again, with histories of single steps, and explains it.
/// @throws Error where its demands are not those of the file
Explained explained(const RepeatedRun& again, const study::UnitSystem& units = {});

}  // namespace gurney::cli
