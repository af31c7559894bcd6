#pragma once

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/base/error.h"
#include "groundmotions/record/record.h"
#include "studies/render/render.h"

namespace gurney::cli {

/// Whether -o names a file: it has an ending of letters, or one of our files (docs/conventions.md). What
/// is a folder already is one.
bool names_a_file(const std::filesystem::path& output);

/// @throws Error where -o names a file for a command that writes several
void require_name_of_folder(const std::filesystem::path& output);

/// A folder for the files of a command, made if it is not there; removed again unless what was put
/// into it is kept.
class NewFolder {
 public:
  /// @param path  may end in a slash
  /// @throws Error if it is a file or named like one, or the folder it should be in is missing or refuses
  explicit NewFolder(const std::filesystem::path& path);
  ~NewFolder();
  NewFolder(const NewFolder&) = delete;
  NewFolder& operator=(const NewFolder&) = delete;

 private:
  std::filesystem::path path_;
  bool made_ = false;
};

/// Source and processing of a record, as comments of a CSV file.
std::vector<std::string> record_comments(const groundmotions::Record& record);

/// The text of a record in Gurney's CSV, with its comments. @throws Error where it could not be read again
std::string record_csv(const groundmotions::Record& record);

/// The name of a record, without what cannot stand in the name of a file.
std::string file_name(std::string record_name);

/// To be called before anything is computed. @throws Error unless a table can be written there, in .csv
void check_csv_output(const std::string& path, bool overwrite);

/// @throws Error if `path` is a file that the record was read from.
void refuse_input_as_output(const std::string& path, const groundmotions::Record& record);

/// Writes one file whole or not at all, and prints its name unless `quiet`. @throws Error as
/// OutputFiles does.
void write_output(const std::string& path, const std::string& text, bool overwrite,
                  bool quiet = false);

/// A folder of this process alone, in that for temporary files, which is there as long as the object.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "gurney_XXXXXX").string();
    require(mkdtemp(name.data()) != nullptr, name + ": cannot be made");
    path_ = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  std::string file(const char* name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

/// Prints what is known, for people or for programs.
/// @param known  a section, or several
inline void print_findings(const auto& known, bool json) {
  fmt::print("{}", json ? render::json(known) : render::text(known));
}

}  // namespace gurney::cli
