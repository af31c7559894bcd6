#pragma once

#include <map>
#include <string>

namespace gurney::workbench {

/// The files that a module has, by absolute path: the shipped data, and what a page adds.
std::map<std::string, std::string>& files();

/// Where the data of an installation are.
inline constexpr const char* kRoot = "/usr/share/gurney/";

/// Adds the regular files of an archive of `tar`, below kRoot.
void add_archive(const char* bytes, std::size_t size);

}  // namespace gurney::workbench
