#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace gurney {

/// The uniform number in (0, 1) number `index` of stream `stream` under `seed`: the same on every
/// machine and in any order.
///
/// Philox 4x64-10 (Salmon, Moraes, Dror & Shaw 2011, SC'11) with the key (seed, stream) and the
/// counter (index, 0, 0, 0): the middle of the cell given by the upper 53 bits of its first word.
double uniform_draw(std::uint64_t seed, std::uint64_t stream, std::uint64_t index);

/// The index below `count` that a uniform number in (0, 1) chooses, each as often as any other.
inline std::size_t drawn_index(double u, std::size_t count) {
  return std::min(count - 1, static_cast<std::size_t>(u * static_cast<double>(count)));
}

/// Standard normal draw: uniform_draw() through normal_quantile().
double normal_draw(std::uint64_t seed, std::uint64_t stream, std::uint64_t index);

/// Inverse of the standard normal distribution function, relative error about 1e-16 (algorithm
/// AS 241, PPND16: Wichura 1988, Applied Statistics 37(3), 477-484).
/// @param probability  in (0, 1)
double normal_quantile(double probability);

/// The standard normal distribution function, erfc(-x / sqrt 2) / 2; exact in the lower tail.
double normal_cdf(double x);

}  // namespace gurney
