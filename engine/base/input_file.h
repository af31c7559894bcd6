#pragma once

#include <cstdint>
#include <string>

namespace gurney {

/// The most bytes that a job, an item or another text file may have.
inline constexpr std::uintmax_t kLargestTextFile = std::uintmax_t{64} << 20;

/// @throws Error `path: ...` unless it is a regular file, or a link to one. A pipe or a device
/// would block, or never end.
void require_regular_file(const std::string& path);

/// The bytes of a regular file.
/// @throws Error also where it has more than `largest` bytes or cannot be read
std::string read_input_file(const std::string& path, std::uintmax_t largest = kLargestTextFile);

}  // namespace gurney
