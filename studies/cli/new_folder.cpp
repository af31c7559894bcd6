#include "studies/cli/new_folder.h"

#include <fmt/format.h>

#include "engine/base/error.h"

namespace gurney::cli {

namespace fs = std::filesystem;

NewFolder::NewFolder(const fs::path& path) : path_(path) {
  std::error_code error;
  const fs::path parent = path.has_parent_path() ? path.parent_path() : ".";
  require(fs::is_directory(parent, error),
          fmt::format("{}: cannot be written: the folder {} does not exist", path.string(),
                      parent.string()));
  require(!fs::exists(path, error) || fs::is_directory(path, error),
          path.string() + ": is a file, the name of a folder is needed (-o FOLDER)");
  made_ = fs::create_directory(path, error);
  require(!error, path.string() + ": cannot be written: " + error.message());
}

NewFolder::~NewFolder() {
  std::error_code ignored;
  if (made_) fs::remove(path_, ignored);  // only if it is empty
}

}  // namespace gurney::cli
