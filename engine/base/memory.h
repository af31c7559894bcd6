#pragma once

#include <cstddef>

namespace gurney {

/// To be called before a library that cannot bear an allocation that fails.
/// @param bytes  what it takes at most [bytes]
/// @throws std::bad_alloc unless so much could be had now
void require_memory(std::size_t bytes);

}  // namespace gurney
