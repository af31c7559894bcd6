#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#if defined(__AVX__)
#include <immintrin.h>
#endif

#if defined(__GNUC__) && !defined(__AVX__)
// Calls that hand over four numbers depend on the CPU class; all code here is built for one.
#pragma GCC diagnostic ignored "-Wpsabi"
#endif

/// Formulas for one number or for four side by side: written for a type T, which is double or
/// Lanes. Both agree to rounding; no result may depend on which of them is used where.
///
/// The vocabulary is that of SIMD libraries: +, -, *, / act lane by lane and take a double for one
/// operand; comparisons give a mask, masks combine with !, & and |; splat, select, any, lane,
/// gather, sqrt, abs, copysign, mul_add. Vectors and matrices of such numbers: vec3.h.
namespace gurney {

/// Four numbers.
using Lanes = double __attribute__((vector_size(32)));
using LaneMask = decltype(Lanes{} < Lanes{});
inline constexpr std::size_t kLanes = 4;

/// How many numbers a T has.
template <class T>
inline constexpr std::size_t kLanesOf = std::is_same_v<T, double> ? 1 : kLanes;

template <class T>
using Mask = decltype(T{} < T{});

/// a b + c, with one rounding where the processor multiplies and adds at once.
inline double mul_add(double a, double b, double c) {
#if defined(__FMA__)
  return std::fma(a, b, c);
#else
  return a * b + c;
#endif
}
inline Lanes mul_add(const Lanes& a, const Lanes& b, const Lanes& c) {
#if defined(__FMA__)
  return _mm256_fmadd_pd(a, b, c);
#else
  return a * b + c;
#endif
}

using std::abs;
using std::copysign;
using std::sqrt;

inline Lanes sqrt(const Lanes& a) {
#if defined(__AVX__)
  return _mm256_sqrt_pd(a);
#else
  return Lanes{std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])};
#endif
}

inline Lanes abs(const Lanes& a) {
  const LaneMask sign = std::bit_cast<LaneMask>(-Lanes{});
  return std::bit_cast<Lanes>(std::bit_cast<LaneMask>(a) & ~sign);
}

inline Lanes copysign(const Lanes& magnitude, const Lanes& sign_of) {
  const LaneMask sign = std::bit_cast<LaneMask>(-Lanes{});
  return std::bit_cast<Lanes>((std::bit_cast<LaneMask>(magnitude) & ~sign) |
                              (std::bit_cast<LaneMask>(sign_of) & sign));
}

inline double select(bool mask, double yes, double no) { return mask ? yes : no; }
inline Lanes select(const LaneMask& mask, const Lanes& yes, const Lanes& no) {
  return mask ? yes : no;
}

inline bool any(bool mask) { return mask; }
inline bool any(const LaneMask& mask) {
#if defined(__AVX__)
  return _mm256_movemask_pd(std::bit_cast<Lanes>(mask)) != 0;
#else
  return (mask[0] | mask[1] | mask[2] | mask[3]) != 0;
#endif
}

/// The k-th number.
inline double lane(double a, std::size_t) { return a; }
inline double lane(const Lanes& a, std::size_t k) { return a[k]; }

/// One number in every lane.
template <class T>
T splat(double a) {
  if constexpr (std::is_same_v<T, double>)
    return a;
  else
    return T{a, a, a, a};
}

/// The numbers of a function of the lane. Avoids a store-forwarding stall: written one by one into
/// memory they would be read back as four with a wait.
template <class Number>
Lanes gather(const Number& number) {
  return Lanes{number(std::size_t{0}), number(std::size_t{1}), number(std::size_t{2}),
               number(std::size_t{3})};
}

/// Writes the numbers of a structure of doubles into one lane of the same one of Lanes.
template <template <class> class Structure>
void set_lane(Structure<Lanes>& to, std::size_t lane, const Structure<double>& from) {
  constexpr std::size_t kCount = sizeof(from) / sizeof(double);
  auto lanes = std::bit_cast<std::array<Lanes, kCount>>(to);
  const auto numbers = std::bit_cast<std::array<double, kCount>>(from);
  for (std::size_t i = 0; i < kCount; ++i) lanes[i][lane] = numbers[i];
  to = std::bit_cast<Structure<Lanes>>(lanes);
}

/// Turns four vectors of four: the k-th entries of all become the k-th.
inline void transpose(Lanes& a, Lanes& b, Lanes& c, Lanes& d) {
  const Lanes ab_even = __builtin_shufflevector(a, b, 0, 4, 2, 6);
  const Lanes ab_odd = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Lanes cd_even = __builtin_shufflevector(c, d, 0, 4, 2, 6);
  const Lanes cd_odd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  a = __builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5);
  b = __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5);
  c = __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7);
  d = __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7);
}

/// Numbers in a row as groups of four, and back. A copy of the whole block would go through memory
/// in other pieces than it is read in, which makes the processor wait.
template <std::size_t Groups>
std::array<Lanes, Groups> loaded(const double* numbers) {
  const auto four = [numbers](std::size_t at) {
#if defined(__AVX__)
    return Lanes(_mm256_loadu_pd(numbers + at));
#else
    return Lanes{numbers[at], numbers[at + 1], numbers[at + 2], numbers[at + 3]};
#endif
  };
  return [&]<std::size_t... G>(std::index_sequence<G...>) {
    return std::array<Lanes, Groups>{four(kLanes * G)...};
  }
  (std::make_index_sequence<Groups>());
}
template <std::size_t Groups>
void store(const std::array<Lanes, Groups>& groups, double* numbers) {
  const auto four = [numbers](std::size_t at, const Lanes& group) {
#if defined(__AVX__)
    _mm256_storeu_pd(numbers + at, group);
#else
    for (std::size_t k = 0; k < kLanes; ++k) numbers[at + k] = group[k];
#endif
  };
  [&]<std::size_t... G>(std::index_sequence<G...>) { (four(kLanes * G, groups[G]), ...); }
  (std::make_index_sequence<Groups>());
}

/// Adds to each of the sums the first `lanes` entries of a value, in order.
template <std::size_t Groups>
[[gnu::always_inline]] inline void add_lanes(const Lanes* values, std::size_t lanes,
                                             std::array<Lanes, Groups>& sums) {
  for (std::size_t g = 0; g < Groups; ++g) {
    std::array<Lanes, 4> v{values[4 * g], values[4 * g + 1], values[4 * g + 2], values[4 * g + 3]};
    transpose(v[0], v[1], v[2], v[3]);
    if (lanes == kLanes)
      sums[g] = (((sums[g] + v[0]) + v[1]) + v[2]) + v[3];
    else
      for (std::size_t k = 0; k < lanes; ++k) sums[g] += v[k];
  }
}

}  // namespace gurney
