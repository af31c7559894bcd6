#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace gurney::groundmotions {

/// Whether a path that does not exist is a pattern: it has `*`, `?` or `[`.
bool is_glob(const std::filesystem::path& path);

/// The files and folders that a pattern such as "recs/*.AT2" names, in order; hidden files are
/// named by patterns with their point only.
std::vector<std::filesystem::path> glob(const std::filesystem::path& pattern);

}  // namespace gurney::groundmotions
