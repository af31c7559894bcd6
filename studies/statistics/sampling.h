#pragma once

#include <cstdint>

namespace gurney {

/// Draw `i` of `n` of a Latin hypercube (McKay, Beckman & Conover 1979, Technometrics 21(2),
/// 239-245): of the n draws of a variable one lies in each of the n cells of (0, 1), at random
/// inside it, and cells of different variables are matched at random.
///
/// A function of its arguments alone: the cell of draw i is a permutation of 0 to n - 1 by a
/// Feistel network of Philox numbers on the next power of 4, walked until it lands below n (Black &
/// Rogaway 2002, CT-RSA). Another n is another plan, not a longer one.
/// @param variable  ordinal or hash of the name
/// @throws Error unless i < n and n <= 2^40.
double latin_hypercube_draw(std::uint64_t seed, std::uint64_t variable, std::uint64_t i,
                            std::uint64_t n);

/// Point `i`, counted from 0, of dimension `dimension` of the Sobol sequence (Sobol 1967) with the
/// direction numbers of Joe & Kuo (2008, SIAM J. Sci. Comput. 30(5), 2635-2654), in Gray-code order
/// (Antonov & Saleev 1979), each dimension with a digital shift of its own by the seed (Cranley &
/// Patterson 1976; L'Ecuyer & Lemieux 2002). The first 2^m points have one in each of 2^m cells,
/// and a plan is continued by going on.
///
/// Dimensions are ordinals, for the first are the best: a hash would not do.
/// @throws Error unless dimension < kSobolDimensions and i < 2^52.
double sobol_draw(std::uint64_t seed, std::uint64_t dimension, std::uint64_t i);

inline constexpr std::uint64_t kSobolDimensions = 3667;

}  // namespace gurney
