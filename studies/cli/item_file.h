#pragma once

#include <string>

namespace gurney::cli {

/// The file of an item on the command line: a name of the catalogue, or a path.
/// @throws Error that begins with what was written
std::string item_file(const std::string& name);

}  // namespace gurney::cli
