#include "groundmotions/suites/glob.h"

#include <glob.h>

namespace gurney::groundmotions {

bool is_glob(const std::filesystem::path& path) {
  std::error_code ignored;
  return path.string().find_first_of("*?[") != std::string::npos &&
         !std::filesystem::exists(path, ignored);
}

std::vector<std::filesystem::path> glob(const std::filesystem::path& pattern) {
  std::vector<std::filesystem::path> paths;
  glob_t found{};
  if (::glob(pattern.c_str(), 0, nullptr, &found) == 0)
    for (std::size_t i = 0; i < found.gl_pathc; ++i) paths.emplace_back(found.gl_pathv[i]);
  ::globfree(&found);
  return paths;
}

}  // namespace gurney::groundmotions
