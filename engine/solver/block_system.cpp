#include "engine/solver/block_system.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace gurney {
namespace {

/// Calls `f` with sizes that the compiler knows where they are those of bodies alone.
template <class F>
void with_sizes(Eigen::Index a, Eigen::Index b, const F& f) {
  if (a == 6 && b == 6)
    f(std::integral_constant<int, 6>{}, std::integral_constant<int, 6>{});
  else
    f(std::integral_constant<int, Eigen::Dynamic>{}, std::integral_constant<int, Eigen::Dynamic>{});
}

}  // namespace

void BlockSystem::set_zero() {
  const auto unknowns = static_cast<std::size_t>(size());
  matrix_.assign(unknowns * unknowns, 0.0);
  right_side_.assign(unknowns, 0.0);
  coupled_.assign(count() * count(), 0);
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
    for (std::size_t n : later_) coupled(m, n) = 1;
  reduce_rows(k);

  auto K = matrix();
  auto b = right_side();
  const Eigen::Index own = size_of(k), at = begin_[k];
  for (std::size_t m : later_)
    with_sizes(size_of(m), own, [&](auto rows, auto inner) {
      constexpr int kRows = decltype(rows)::value, kOwn = decltype(inner)::value;
      const Eigen::Index row = begin_[m], size = size_of(m);
      const auto left = K.template block<kRows, kOwn>(row, at, size, own);
      b.template segment<kRows>(row, size).noalias() -=
          left.lazyProduct(b.template segment<kOwn>(at, own));
      for (std::size_t n : later_)
        with_sizes(size_of(n), own, [&](auto columns, auto) {
          constexpr int kColumns = decltype(columns)::value;
          const Eigen::Index column = begin_[n], width = size_of(n);
          K.template block<kRows, kColumns>(row, column, size, width).noalias() -=
              left.lazyProduct(K.template block<kOwn, kColumns>(at, column, own, width));
        });
    });
}

/// Replaces K_kN and b_k by W_N and b_k'. The rows [K_kk K_kN ... b_k] are worked on one after the other.
void BlockSystem::reduce_rows(std::size_t k) {
  auto K = matrix();
  auto b = right_side();
  const Eigen::Index own = size_of(k), at = begin_[k];
  Eigen::Index width = own + 1;
  for (std::size_t n : later_) width += size_of(n);
  rows_.resize(static_cast<std::size_t>(own * width));
  const auto row = [&](Eigen::Index i) { return rows_.data() + i * width; };
  const auto visit = [&](const auto& move) {  // (place in a row, entry of K or b)
    for (Eigen::Index i = 0; i < own; ++i) {
      double* place = row(i);
      for (Eigen::Index j = 0; j < own; ++j) move(*place++, K(at + i, at + j));
      for (std::size_t n : later_)
        for (Eigen::Index j = begin_[n]; j < begin_[n + 1]; ++j) move(*place++, K(at + i, j));
      move(*place, b[at + i]);
    }
  };
  visit([](double& place, double entry) { place = entry; });
  for (Eigen::Index c = 0; c < own; ++c) {
    Eigen::Index pivot = c;
    for (Eigen::Index i = c + 1; i < own; ++i)
      if (std::abs(row(i)[c]) > std::abs(row(pivot)[c])) pivot = i;
    if (pivot != c) std::swap_ranges(row(c) + c, row(c) + width, row(pivot) + c);
    const double* const from = row(c);
    for (Eigen::Index j = c + 1; j < width; ++j) row(c)[j] /= from[c];
    for (Eigen::Index i = 0; i < own; ++i) {
      if (i == c) continue;
      double* const to = row(i);
      const double factor = to[c];
      for (Eigen::Index j = c + 1; j < width; ++j) to[j] -= factor * from[j];
    }
  }
  visit([](double place, double& entry) { entry = place; });
}

void BlockSystem::solve() {
  for (std::size_t k = 0; k < count(); ++k) eliminate(k);
  auto K = matrix();
  auto x = right_side();
  for (std::size_t k = count(); k-- > 0;)
    for (std::size_t n = k + 1; n < count(); ++n)
      if (coupled(k, n))
        x.segment(begin_[k], size_of(k)) -= K.block(begin_[k], begin_[n], size_of(k), size_of(n))
                                                .lazyProduct(x.segment(begin_[n], size_of(n)));
}

}  // namespace gurney
