#include "engine/solver/block_system.h"

#include <type_traits>

namespace gurney {
namespace {

/// Calls `f` with a size that the compiler knows where it is that of a body alone.
template <class F>
void with_size(Eigen::Index size, const F& f) {
  if (size == 6)
    f(std::integral_constant<int, 6>{});
  else
    f(std::integral_constant<int, Eigen::Dynamic>{});
}

template <int Size>
constexpr int kMost = Size == Eigen::Dynamic ? BlockSystem::kMaxSize : Size;
template <int Rows, int Columns>
using Block = Eigen::Matrix<double, Rows, Columns, 0, kMost<Rows>, kMost<Columns>>;

}  // namespace

void BlockSystem::set_zero() {
  const auto unknowns = static_cast<std::size_t>(size());
  matrix_.assign(unknowns * unknowns, 0.0);
  right_side_.assign(unknowns, 0.0);
  coupled_.assign(count() * count(), 0);
}

/// With the rows of block k, K_kk x_k + sum of K_kN x_N = b_k, written as
///
///     x_k = b_k' - sum of W_N x_N,   W_N = K_kk^-1 K_kN,   b_k' = K_kk^-1 b_k,
///
/// those of each later block M become K_MN - K_Mk W_N and b_M - K_Mk b_k'.
void BlockSystem::eliminate(std::size_t k) {
  auto K = matrix();
  auto b = right_side();
  later_.clear();
  for (std::size_t n = k + 1; n < count(); ++n)
    if (coupled(k, n)) later_.push_back(n);
  for (std::size_t m : later_)
    for (std::size_t n : later_) coupled(m, n) = 1;

  const Eigen::Index own = size_of(k), at = begin_[k];
  with_size(own, [&](auto fixed) {
    constexpr int kOwn = decltype(fixed)::value;
    const Block<kOwn, kOwn> inverse =
        Block<kOwn, kOwn>(K.template block<kOwn, kOwn>(at, at, own, own)).inverse();
    const Block<kOwn, 1> solved = inverse.lazyProduct(b.template segment<kOwn>(at, own));
    b.template segment<kOwn>(at, own) = solved;
    for (std::size_t n : later_)
      with_size(size_of(n), [&](auto fixed_other) {
        constexpr int kOther = decltype(fixed_other)::value;
        const Eigen::Index other = size_of(n), column = begin_[n];
        auto block = K.template block<kOwn, kOther>(at, column, own, other);
        const Block<kOwn, kOther> w = inverse.lazyProduct(block);
        block = w;
        for (std::size_t m : later_)
          with_size(size_of(m), [&](auto fixed_row) {
            constexpr int kRow = decltype(fixed_row)::value;
            const Eigen::Index rows = size_of(m), row = begin_[m];
            K.template block<kRow, kOther>(row, column, rows, other).noalias() -=
                K.template block<kRow, kOwn>(row, at, rows, own).lazyProduct(w);
          });
        b.template segment<kOther>(column, other).noalias() -=
            K.template block<kOther, kOwn>(column, at, other, own).lazyProduct(solved);
      });
  });
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
