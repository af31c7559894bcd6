#include "studies/cli/new_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "engine/base/error.h"

namespace gurney::cli {

namespace fs = std::filesystem;

bool names_a_file(const fs::path& output) {
  std::error_code ignored;
  std::string ending = output.extension().string();
  if (ending.size() < 2 || fs::is_directory(output, ignored)) return false;
  ending.erase(0, 1);
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  return ending == "h5" || ending == "AT2" || std::ranges::all_of(ending, is_letter);
}

void require_name_of_folder(const fs::path& output) {
  std::error_code ignored;
  require(!fs::exists(output, ignored) || fs::is_directory(output, ignored),
          output.string() + ": is a file, the name of a folder is needed (-o FOLDER)");
  require(!names_a_file(output),
          fmt::format("{}: is named like a file, but several are written: name a folder (-o {})",
                      output.string(), fs::path(output).replace_extension().string()));
}

NewFolder::NewFolder(const fs::path& path)
    : path_(path.has_filename() ? path : path.parent_path()) {
  std::error_code error;
  const fs::path parent = path_.has_parent_path() ? path_.parent_path() : ".";
  require(fs::is_directory(parent, error),
          fmt::format("{}: cannot be written: the folder {} does not exist", path_.string(),
                      parent.string()));
  require_name_of_folder(path_);
  made_ = fs::create_directory(path_, error);
  require(!error, path_.string() + ": cannot be written: " + error.message());
}

NewFolder::~NewFolder() {
  std::error_code ignored;
  if (made_) fs::remove(path_, ignored);  // only if it is empty
}

}  // namespace gurney::cli
