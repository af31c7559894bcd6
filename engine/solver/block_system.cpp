#include "engine/solver/block_system.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "engine/base/lanes.h"

namespace gurney {
namespace {

constexpr Eigen::Index kFour = kLanes;
/// Unknowns of a body without casters that keep theirs: sizes that the compiler knows.
constexpr int kBody = 6;

Lanes four(const double* numbers) { return loaded<1>(numbers)[0]; }
void put(const Lanes& four, double* numbers) { store<1>({four}, numbers); }

constexpr Eigen::Index rounded_up(Eigen::Index count) {
  return (count + kFour - 1) / kFour * kFour;
}

/// C -= A B for rows of whole groups of four. kSize: of all three blocks; 0: as stated.
template <int kSize>
void subtract_matrices(const double* a, Eigen::Index stride_a, const double* b, double* c,
                       Eigen::Index rows, Eigen::Index inner, Eigen::Index length) {
  if constexpr (kSize > 0) rows = inner = kSize, length = stride_a = rounded_up(kSize);
  for (Eigen::Index i = 0; i < rows; ++i)
    for (Eigen::Index j = 0; j < length; j += kFour) {
      Lanes sum = four(c + i * length + j);
      for (Eigen::Index p = 0; p < inner; ++p)
        sum = mul_add(splat<Lanes>(-a[i * stride_a + p]), four(b + p * length + j), sum);
      put(sum, c + i * length + j);
    }
}

/// Product of a row of whole groups of four with a column.
double product(const double* row, const double* column, Eigen::Index length) {
  Lanes sum{};
  for (Eigen::Index j = 0; j < length; j += kFour)
    sum = mul_add(four(row + j), four(column + j), sum);
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

}  // namespace

std::size_t BlockSystem::add_block(Eigen::Index size) {
  sizes_.push_back(size);
  return sizes_.size() - 1;
}

Eigen::Index BlockSystem::stride(std::size_t b) const { return rounded_up(size_of(b)); }

void BlockSystem::add_numbers(std::size_t a, std::size_t b) {
  place(a, b) = numbers_.size();
  numbers_.resize(numbers_.size() + static_cast<std::size_t>(size_of(a) * stride(b)), 0.0);
}

void BlockSystem::set_zero() {
  places_.assign(count() * count(), kNone);
  numbers_.clear();
  side_places_.clear();
  std::size_t sides = 0;
  for (std::size_t k = 0; k < count(); ++k) {
    add_numbers(k, k);
    side_places_.push_back(sides);
    sides += static_cast<std::size_t>(stride(k));
  }
  sides_.assign(sides, 0.0);
}

void BlockSystem::couple(std::size_t a, std::size_t b) {
  if (a == b || coupled(a, b)) return;
  add_numbers(a, b);
  add_numbers(b, a);
}

auto BlockSystem::later(std::size_t k) const {
  const std::size_t begin = k > 0 ? later_end_[k - 1] : 0;
  return std::span(later_).subspan(begin, later_end_[k] - begin);
}

inline void BlockSystem::Rows::swap(Eigen::Index i, Eigen::Index k) const {
  std::swap_ranges(row(i), row(i) + stride, row(k));
}

inline void BlockSystem::Rows::multiply(Eigen::Index i, double factor) const {
  double* const to = row(i);
  for (Eigen::Index j = 0; j < stride; j += kFour) put(splat<Lanes>(factor) * four(to + j), to + j);
}

inline void BlockSystem::Rows::subtract(double factor, Eigen::Index from, Eigen::Index i) const {
  const double* const other = row(from);
  double* const to = row(i);
  for (Eigen::Index j = 0; j < stride; j += kFour)
    put(mul_add(splat<Lanes>(-factor), four(other + j), four(to + j)), to + j);
}

/// With the rows of block k, K_kk x_k + sum of K_kN x_N = b_k, written as
///
///     x_k = K_kk^-1 b_k - sum of W_N x_N,   W_N = K_kk^-1 K_kN,
///
/// by Gauss and Jordan, K_MN of two later blocks becomes K_MN - K_Mk W_N, and b_M, in solve(),
/// b_M - K_Mk K_kk^-1 b_k.
void BlockSystem::eliminate(std::size_t k) {
  for (std::size_t n = k + 1; n < count(); ++n)
    if (coupled(k, n)) later_.push_back(n);
  later_end_.push_back(later_.size());
  for (std::size_t m : later(k))
    for (std::size_t n : later(k)) couple(m, n);
  const Eigen::Index own = size_of(k);
  own == kBody ? reduce_rows<kBody>(k) : reduce_rows<0>(k);
  for (std::size_t m : later(k))
    for (std::size_t n : later(k)) {
      const bool are_bodies = own == kBody && size_of(m) == kBody && size_of(n) == kBody;
      const auto subtract = are_bodies ? subtract_matrices<kBody> : subtract_matrices<0>;
      subtract(&numbers_[place(m, k)], stride(k), &numbers_[place(k, n)], &numbers_[place(m, n)],
               size_of(m), own, stride(n));
    }
}

/// Replaces K_kk by its inverse, in its own place, and K_kN by W_N.
template <int kSize>
void BlockSystem::reduce_rows(std::size_t k) {
  const Eigen::Index own = kSize > 0 ? kSize : size_of(k);
  rows_.clear();
  for (std::size_t n : later(k)) rows_.push_back({&numbers_[place(k, n)], stride(n)});
  const Rows K{&numbers_[place(k, k)], kSize > 0 ? rounded_up(kSize) : stride(k)};
  pivots_.clear();
  for (Eigen::Index c = 0; c < own; ++c) {
    Eigen::Index pivot = c;
    for (Eigen::Index i = c + 1; i < own; ++i)
      if (std::abs(K.row(i)[c]) > std::abs(K.row(pivot)[c])) pivot = i;
    pivots_.push_back(pivot);
    if (pivot != c) {
      K.swap(c, pivot);
      for (const Rows& rows : rows_) rows.swap(c, pivot);
    }
    const double inverse = 1 / K.row(c)[c];
    K.row(c)[c] = 1;
    K.multiply(c, inverse);
    for (const Rows& rows : rows_) rows.multiply(c, inverse);
    for (Eigen::Index i = 0; i < own; ++i) {
      if (i == c) continue;
      const double factor = K.row(i)[c];
      K.row(i)[c] = 0;
      K.subtract(factor, c, i);
      for (const Rows& rows : rows_) rows.subtract(factor, c, i);
    }
  }
  // Rows that were exchanged are columns of the inverse.
  for (Eigen::Index c = own; c-- > 0;)
    if (const Eigen::Index pivot = pivots_[static_cast<std::size_t>(c)]; pivot != c)
      for (Eigen::Index i = 0; i < own; ++i) std::swap(K.row(i)[c], K.row(i)[pivot]);
}

void BlockSystem::factor() {
  later_.clear();
  later_end_.clear();
  for (std::size_t k = 0; k < count(); ++k) eliminate(k);
}

void BlockSystem::subtract_product(std::size_t m, std::size_t n, double* y) const {
  const double* row = &numbers_[place(m, n)];
  const double* const x = &sides_[side_places_[n]];
  for (Eigen::Index i = 0; i < size_of(m); ++i, row += stride(n))
    y[i] -= product(row, x, stride(n));
}

void BlockSystem::solve() {
  const auto side = [&](std::size_t k) { return &sides_[side_places_[k]]; };
  for (std::size_t k = 0; k < count(); ++k) {
    own_.assign(side(k), side(k) + stride(k));
    for (Eigen::Index i = 0; i < size_of(k); ++i)
      side(k)[i] = product(&numbers_[place(k, k)] + i * stride(k), own_.data(), stride(k));
    for (std::size_t m : later(k)) subtract_product(m, k, side(m));
  }
  for (std::size_t k = count(); k-- > 0;)
    for (std::size_t n : later(k)) subtract_product(k, n, side(k));
}

}  // namespace gurney
