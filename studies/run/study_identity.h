#pragma once

#include <filesystem>
#include <string>

#include "studies/run/run_task.h"

namespace gurney::study {

/// Inputs that decide a study's numbers, as text: lines `key = value` for the job, each record and
/// each data file, an empty line, and the job itself.
std::string inputs_of(const Batch& batch);

/// Inputs and the program that makes the runs: what must be equal for runs to belong together.
std::string identity_of(const Batch& batch);

/// The number of analysis cases in identity_of().
/// @throws Error where it has none
std::size_t tasks_in(const std::string& identity);

/// The number of stages of the study of identity_of(), 1 unless its stripes are adaptive.
std::size_t stages_in(const std::string& identity);

/// From the parts of inputs_of(), such as those that results keep.
/// @param lines  `key = value`
std::string inputs_from(const std::string& lines, const std::string& job_text);

std::string record_line(const std::string& set, const std::string& name, const std::string& files);
std::string data_file_line(const std::string& name, const std::string& sha256);

/// The job's text in it.
std::string job_text_in(const std::string& identity);

/// How two identities differ: `item.toml: there '1', here '2'`, of a job by the keys that differ;
/// empty only where they are equal.
std::string difference(const std::string& theirs, const std::string& ours);

/// Compares two jobs; empty: they differ in nothing that is read.
std::string job_difference(const std::string& theirs, const std::string& ours);

/// Likewise in what a run is, whatever runs there are: without title, item of the job, combinations, intensity
/// levels, and levels of factors that only one of them has; files by their names alone.
std::string run_difference(const std::string& theirs, const std::string& ours);

/// The file `study` of a folder of parts, which states whose they are: a line with the SHA-256 of
/// the identity (study_identity.h), and the identity.
class IdentityFile {
 public:
  explicit IdentityFile(const std::filesystem::path& folder);

  bool exists() const { return exists_; }  ///< and has any bytes
  bool damaged() const { return damaged_; }

  /// @throws Error for a damaged file; empty for none
  const std::string& identity() const;

  static std::string bytes_of(const std::string& identity);

 private:
  std::filesystem::path path_;
  std::string identity_;
  bool exists_ = false, damaged_ = false;
};

}  // namespace gurney::study
