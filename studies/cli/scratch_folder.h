#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

#include "engine/base/error.h"

namespace gurney::cli {

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

}  // namespace gurney::cli
