#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/config/document.h"
#include "engine/config/file_snapshot.h"
#include "engine/config/node.h"
#include "studies/job/job.h"
#include "studies/plan/study.h"

namespace gurney::study {

/// Adds each value of a tree by its dotted key under `path`; tables of an array by their name, or
/// else by their number from 1: `item[bed].mass_kg`.
void flatten(const config::Node& node, const std::string& path,
             std::map<std::string, std::string>& entries);

/// One combination of levels, one of each factor.
struct Configuration {
  std::vector<std::string> levels;  ///< names, in the order of the factors
  config::Node tree;                ///< the job with their patches
};

/// A job file with a table [study], and the jobs that it stands for. Each is read once, from files
/// of which each is opened once: an edit while the study runs changes nothing.
class StudyJob {
 public:
  /// @throws Error with every error: of the study, and of the job in any configuration.
  explicit StudyJob(const std::string& path);

  /// Reads the job from text, such as that kept in a results file.
  /// @param path  for messages and relative names
  StudyJob(const std::string& text, const std::string& path);

  const Study& study() const { return study_; }
  const std::vector<Configuration>& configurations() const { return configurations_; }
  const std::string& text() const { return document_->text(); }
  const std::string& file() const { return document_->path(); }

  /// On keys of earlier versions, which are still read.
  const std::vector<std::string>& notes() const { return notes_; }

  /// The job file and those it names, as they were read. What else belongs to the study is to be
  /// read in their scope.
  config::FileSnapshot& files() const { return *files_; }

  /// The job of a configuration. May be called from several threads at once.
  /// @param draw  none: every parameter has its value
  /// @param replica  under a change that nobody can measure: number of replica_of(); 0: without
  /// @throws Error where this draw makes a bad job, such as items that overlap.
  Job job(std::size_t configuration, const std::optional<Draw>& draw,
          std::size_t replica = 0) const;

 private:
  StudyJob(std::unique_ptr<config::FileSnapshot> files, std::unique_ptr<config::Document> document);

  bool draws_anything() const;
  void check_limit_states(const config::Node& study, const Job& job) const;

  std::unique_ptr<config::FileSnapshot> files_;
  std::unique_ptr<config::Document> document_;
  std::vector<std::string> notes_;
  Study study_;
  std::vector<Configuration> configurations_;
  std::vector<JobModel> models_;  ///< as configurations_
};

/// Whether a job file has a table [study].
/// @throws Error if it is missing or is not TOML.
bool has_study(const std::string& path);

/// Every file that decides a study's numbers beside the job and the records: items, casters, floor
/// coverings, rooms, tethers, buildings, target spectra, lists of records. They are those that were
/// read, with the bytes that were used; the motions (StudyMotions) are to be there, too.
/// @return SHA-256 by name: `equipment/casters/R100.toml` of the catalogue's, others relative to
///         the job's folder
std::map<std::string, std::string> data_files(const StudyJob& job);

}  // namespace gurney::study
