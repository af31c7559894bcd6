#pragma once

#include <cstdint>
#include <string>

namespace gurney {

/// SHA-256 of the first bytes of a file, 64 hexadecimal digits. Memory does not grow with them.
/// @throws Error where the file has fewer bytes or cannot be read
std::string sha256_of_file(const std::string& path, std::uintmax_t bytes);

}  // namespace gurney
