#include "engine/solver/block_system.h"

#include <algorithm>
#include <cmath>

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
void subtract_product(const double* a, Eigen::Index stride_a, const double* b, double* c,
                      Eigen::Index stride_c, Eigen::Index rows, Eigen::Index inner,
                      Eigen::Index length) {
  if constexpr (kSize > 0) rows = inner = kSize, length = stride_a = rounded_up(kSize);
  for (Eigen::Index i = 0; i < rows; ++i)
    for (Eigen::Index j = 0; j < length; j += kFour) {
      Lanes sum = four(c + i * stride_c + j);
      for (Eigen::Index p = 0; p < inner; ++p)
        sum = mul_add(splat<Lanes>(-a[i * stride_a + p]), four(b + p * length + j), sum);
      put(sum, c + i * stride_c + j);
    }
}

}  // namespace

void BlockSystem::clear() { sizes_.clear(); }

std::size_t BlockSystem::add_block(Eigen::Index size) {
  sizes_.push_back(size);
  return sizes_.size() - 1;
}

Eigen::Index BlockSystem::stride(std::size_t a, std::size_t b) const {
  return rounded_up(size_of(b) + (a == b ? 1 : 0));
}

void BlockSystem::add_numbers(std::size_t a, std::size_t b) {
  place(a, b) = numbers_.size();
  numbers_.resize(numbers_.size() + static_cast<std::size_t>(size_of(a) * stride(a, b)), 0.0);
}

void BlockSystem::set_zero() {
  places_.assign(count() * count(), kNone);
  numbers_.clear();
  for (std::size_t k = 0; k < count(); ++k) add_numbers(k, k);
}

void BlockSystem::couple(std::size_t a, std::size_t b) {
  if (a == b || coupled(a, b)) return;
  add_numbers(a, b);
  add_numbers(b, a);
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
///     x_k = b_k' - sum of W_N x_N,   W_N = K_kk^-1 K_kN,   b_k' = K_kk^-1 b_k
///
/// by Gauss and Jordan, those of each later block M become K_MN - K_Mk W_N and b_M - K_Mk b_k'.
void BlockSystem::eliminate(std::size_t k) {
  later_.clear();
  for (std::size_t n = k + 1; n < count(); ++n)
    if (coupled(k, n)) later_.push_back(n);
  for (std::size_t m : later_)
    for (std::size_t n : later_) couple(m, n);
  const Eigen::Index own = size_of(k);
  own == kBody ? reduce_rows<kBody>(k) : reduce_rows<0>(k);

  const Column b_k = right_side(k);
  for (std::size_t m : later_) {
    const double* const left = &numbers_[place(m, k)];
    const Eigen::Index rows = size_of(m);
    right_side(m).noalias() -= block(m, k).lazyProduct(b_k);
    for (std::size_t n : later_) {
      const bool are_bodies = own == kBody && rows == kBody && size_of(n) == kBody;
      const auto subtract = are_bodies ? subtract_product<kBody> : subtract_product<0>;
      subtract(left, stride(m, k), &numbers_[place(k, n)], &numbers_[place(m, n)], stride(m, n),
               rows, own, stride(k, n));
    }
  }
}

/// Replaces K_kN and b_k by W_N and b_k'.
template <int kSize>
void BlockSystem::reduce_rows(std::size_t k) {
  const Eigen::Index own = kSize > 0 ? kSize : size_of(k);
  rows_.clear();
  for (std::size_t n : later_) rows_.push_back({&numbers_[place(k, n)], stride(k, n)});
  const Rows K{&numbers_[place(k, k)], kSize > 0 ? rounded_up(kSize + 1) : stride(k, k)};
  for (Eigen::Index c = 0; c < own; ++c) {
    Eigen::Index pivot = c;
    for (Eigen::Index i = c + 1; i < own; ++i)
      if (std::abs(K.row(i)[c]) > std::abs(K.row(pivot)[c])) pivot = i;
    if (pivot != c) {
      K.swap(c, pivot);
      for (const Rows& rows : rows_) rows.swap(c, pivot);
    }
    const double inverse = 1 / K.row(c)[c];
    K.multiply(c, inverse);
    for (const Rows& rows : rows_) rows.multiply(c, inverse);
    for (Eigen::Index i = 0; i < own; ++i) {
      if (i == c) continue;
      const double factor = K.row(i)[c];
      K.subtract(factor, c, i);
      for (const Rows& rows : rows_) rows.subtract(factor, c, i);
    }
  }
}

void BlockSystem::solve() {
  for (std::size_t k = 0; k < count(); ++k) eliminate(k);
  for (std::size_t k = count(); k-- > 0;)
    for (std::size_t n = k + 1; n < count(); ++n)
      if (coupled(k, n)) right_side(k).noalias() -= block(k, n).lazyProduct(right_side(n));
}

}  // namespace gurney
