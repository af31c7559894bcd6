#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace gurney::groundmotions {

/// Names a file that is known well but is no record (an archive, an HDF5 file, XML, a picture,
/// ...), by its first bytes, and what to do about it; nothing for any other.
std::optional<std::string> foreign_file(std::string_view bytes);

}  // namespace gurney::groundmotions
