#pragma once

#include <string>
#include <vector>

namespace gurney::cli {

/// `gurney equipment check`: reads files of items, casters, floor coverings, rooms and tethers and
/// prints what they are, or every error.
/// @returns 0, or 1 where a file has errors
int check_equipment(const std::vector<std::string>& files, bool json);

}  // namespace gurney::cli
