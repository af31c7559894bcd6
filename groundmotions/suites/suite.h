#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "groundmotions/assembly/read_record.h"

namespace gurney::groundmotions {

/// A record of a suite: which files, and how they are to be read.
struct SuiteRecord {
  std::string name;
  std::vector<RecordFile> files;
  ReadOptions options = {};
  double scale = 1;                                        ///< on every component, > 0
  std::vector<std::pair<std::string, std::string>> facts;  ///< of the source: name, value
};

/// A file that was left out, and why.
struct Refusal {
  std::string file;  ///< or name of the record
  std::string reason;
};

/// Reason with the file, which is named once.
std::string text_of(const Refusal& refusal);

/// Records that belong together; not read yet.
struct Suite {
  std::vector<SuiteRecord> records;
  std::vector<Refusal> refused;
  std::vector<std::string> notes;     ///< what is not there or not needed, one sentence each
  std::vector<std::string> warnings;  ///< what may not be meant so, one sentence each
};

/// Called before each file with how many are done and how many there are.
using Progress = std::function<void(std::size_t, std::size_t)>;

/// The records behind some paths: folders (folder_suite.h), lists and PEER _SearchResults.csv
/// (known by their content), and record files, which are grouped into records as those of a folder
/// are. A pattern such as "recs/*.AT2" stands for all that it names.
///
/// @param options  for files that do not say their unit or time step
/// @throws Error if a path does not exist, a pattern names nothing or a list is wrong. Files that
/// are no records are refused
///         one by one.
Suite read_suite(const std::vector<std::filesystem::path>& paths, const ReadOptions& options = {},
                 const Progress& progress = {});

/// Reads and assembles one record and scales it as its list says.
/// @throws Error as read_record() for files does.
Record read_record(const SuiteRecord& record);

/// Whether a path that does not exist is a pattern: it has `*`, `?` or `[`.
bool is_glob(const std::filesystem::path& path);

/// The files and folders that a pattern such as "recs/*.AT2" names, in order; hidden files are
/// named by patterns with their point only.
std::vector<std::filesystem::path> glob(const std::filesystem::path& pattern);

}  // namespace gurney::groundmotions
