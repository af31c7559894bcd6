#pragma once

#include <cstdint>

namespace gurney {

/// How the draws of a study fill the space of what is uncertain.
enum class Sampling {
  kMonteCarlo,     ///< each by itself
  kLatinHypercube  ///< each variable has one draw in each of n cells of equal probability (McKay,
                   ///< Beckman & Conover 1979, Technometrics 21(2), 239-245)
};

/// The place of `index` in a permutation of 0 to size - 1 that depends on (seed, stream) alone.
///
/// A Feistel network of four rounds with Philox as its round function on the smallest even number
/// of bits that holds `size`, walked until it falls inside (Black & Rogaway 2002, CT-RSA, 114-130).
/// @param index  below `size`
std::uint64_t permuted(std::uint64_t seed, std::uint64_t stream, std::uint64_t index,
                       std::uint64_t size);

}  // namespace gurney
