#include "engine/base/random/sampling.h"

#include <Random123/philox.h>

#include <bit>
#include <cassert>

namespace gurney {

std::uint64_t permuted(std::uint64_t seed, std::uint64_t stream, std::uint64_t index,
                       std::uint64_t size) {
  assert(index < size);
  const int bits = (std::bit_width(size - 1) + 1) / 2;
  const std::uint64_t mask = (std::uint64_t{1} << bits) - 1;
  r123::Philox4x64 generator;
  do {
    std::uint64_t left = index >> bits, right = index & mask;
    for (std::uint64_t round = 0; round < 4; ++round) {
      const auto noise = generator({right, round, 1, 0}, {seed, stream})[0];
      const std::uint64_t mixed = left ^ (noise & mask);
      left = right;
      right = mixed;
    }
    index = (left << bits) | right;
  } while (index >= size);
  return index;
}

}  // namespace gurney
