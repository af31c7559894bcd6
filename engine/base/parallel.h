#pragma once

#include <cstddef>
#include <functional>

namespace gurney {

/// Calls work(i) for each i < count, on `threads` > 0 threads, in no order. What a call throws ends the
/// loop: no further call begins, and the first exception is thrown here when all have ended. (An exception that
/// leaves a region of OpenMP ends the process.)
void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& work);

/// @returns `asked`, or one for each core where it is not > 0
int threads_or_all(int asked = 0);

}  // namespace gurney
