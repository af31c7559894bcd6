#include "engine/solver/solve6.h"

#include <cmath>
#include <utility>

#include "engine/base/lanes.h"

namespace gurney {
namespace {

/// Sum of Count products of a row of `a` from column From on with `x`, halves first.
template <int From, int Count>
double sum(const Matrix6& a, int row, const Vector6& x) {
  if constexpr (Count == 1)
    return a(row, From) * x[From];
  else
    return sum<From, Count / 2>(a, row, x) + sum<From + Count / 2, Count - Count / 2>(a, row, x);
}

template <int K>
void swap_in_pivot(Matrix6& a, Vector6& x) {
  int pivot = K;
  for (int row = K + 1; row < 6; ++row)
    if (std::abs(a(row, K)) > std::abs(a(pivot, K))) pivot = row;
  if (pivot == K) return;
  for (int column = 0; column < 6; ++column) std::swap(a(K, column), a(pivot, column));
  std::swap(x[K], x[pivot]);
}

/// Beside the elimination, whose numbers it does not wait for.
template <int K>
void substitute_forward(const Matrix6& a, Vector6& x) {
  if constexpr (K > 0) x[K] -= sum<0, K>(a, K, x);
}

template <int K>
void eliminate_below(Matrix6& a, Vector6& x) {
  constexpr int kBelow = 5 - K;
  swap_in_pivot<K>(a, x);
  substitute_forward<K>(a, x);
  if (a(K, K) != 0) a.col(K).tail<kBelow>() /= a(K, K);
  for (int column = K + 1; column < 6; ++column)
    a.col(column).tail<kBelow>() -= a(K, column) * a.col(K).tail<kBelow>();
}

template <int... K>
void eliminate(Matrix6& a, Vector6& x, std::integer_sequence<int, K...>) {
  (eliminate_below<K>(a, x), ...);
  substitute_forward<5>(a, x);
}

template <int... K>
void substitute(const Matrix6& a, Vector6& x, std::integer_sequence<int, K...>) {
  x[5] /= a(5, 5);
  ((x[4 - K] = (x[4 - K] - sum<5 - K, K + 1>(a, 4 - K, x)) / a(4 - K, 4 - K)), ...);
}

}  // namespace

Vector6 solve6(const Matrix6& matrix, const Vector6& b) {
  Matrix6 a;
  store(loaded<9>(matrix.data()), a.data());
  constexpr std::make_integer_sequence<int, 5> kColumns;
  Vector6 x = b;
  eliminate(a, x, kColumns);
  substitute(a, x, kColumns);
  return x;
}

}  // namespace gurney
