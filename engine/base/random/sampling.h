#pragma once

#include <cstdint>

namespace gurney {

/// How the draws of a study fill the space of what is uncertain.
enum class Sampling {
  kMonteCarlo,      ///< each by itself
  kLatinHypercube,  ///< each variable evenly over all draws
  kSobol,           ///< all variables together evenly
  kSaltelli         ///< twice as by kSobol, and mixed one input at a time: for variance indices
};

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

/// A row of a Saltelli design (Saltelli et al. 2010, Computer Physics Communications 181(2),
/// 259-270) of k inputs: each point gives one row in each of the matrices A, B and AB_1 to AB_k.
struct SaltelliRow {
  std::uint64_t point = 0;
  std::uint64_t matrix = 0;  ///< 0: A; 1: B; 2 + i: A with input i from B

  bool from_b(std::uint64_t input) const { return matrix == 1 || matrix == 2 + input; }
};

inline constexpr std::uint64_t kSaltelliMatrices = 2;  ///< besides one for each input

/// Input `input` of `inputs` in a row: A and B are the halves of a Sobol sequence of twice as many
/// dimensions.
/// @throws Error unless 2 inputs <= kSobolDimensions, input < inputs and the point is below 2^52.
double saltelli_draw(std::uint64_t seed, std::uint64_t inputs, std::uint64_t input,
                     const SaltelliRow& row);

}  // namespace gurney
