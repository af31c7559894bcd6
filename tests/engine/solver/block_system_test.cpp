#include "engine/solver/block_system.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <array>
#include <memory>
#include <random>
#include <utility>
#include <vector>

namespace gurney {
namespace {

/// Bodies of these sizes with masses on the diagonal, and slopes that are not symmetric between the pairs.
struct Example {
  std::vector<Eigen::Index> sizes;
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
};

using Number = std::uniform_real_distribution<double>;

/// Blocks of the example with random numbers, and a diagonal that dominates.
BlockSystem filled(const Example& example, std::mt19937& random) {
  Number number(-1, 1);
  BlockSystem system;
  for (std::size_t k = 0; k < example.sizes.size(); ++k)
    EXPECT_EQ(system.add_block(example.sizes[k]), k);
  system.set_zero();
  for (const auto& [a, b] : example.pairs) system.couple(a, b);
  for (std::size_t a = 0; a < system.count(); ++a)
    for (std::size_t b = 0; b < system.count(); ++b) {
      if (!system.coupled(a, b)) continue;
      BlockSystem::Block block = system.block(a, b);
      EXPECT_EQ(block.norm(), 0) << "zero at first";
      for (Eigen::Index i = 0; i < block.rows(); ++i)
        for (Eigen::Index j = 0; j < block.cols(); ++j)
          block(i, j) = number(random) + (a == b && i == j ? 60 : 0);
    }
  for (std::size_t k = 0; k < system.count(); ++k)
    for (double& each : system.right_side(k)) each = number(random);
  return system;
}

/// K and b, or x, of all blocks.
std::pair<Eigen::MatrixXd, Eigen::VectorXd> whole(BlockSystem& system) {
  std::vector<Eigen::Index> begin{0};
  for (std::size_t k = 0; k < system.count(); ++k) begin.push_back(begin[k] + system.size_of(k));
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(begin.back(), begin.back());
  Eigen::VectorXd b(begin.back());
  for (std::size_t m = 0; m < system.count(); ++m) {
    b.segment(begin[m], system.size_of(m)) = system.right_side(m);
    for (std::size_t n = 0; n < system.count(); ++n)
      if (system.coupled(m, n))
        K.block(begin[m], begin[n], system.size_of(m), system.size_of(n)) = system.block(m, n);
  }
  return {K, b};
}

/// Norm of K x - b, with K and b as they were before, over that of b.
double residual_of(const Example& example, std::mt19937& random) {
  BlockSystem system = filled(example, random);
  const auto [K, b] = whole(system);
  system.factor();
  system.solve();
  return (K * whole(system).second - b).norm() / b.norm();
}

// Rounding of some 100 operations an entry; diagonals dominate.
constexpr double kRounding = 1e-13;

TEST(BlockSystem, SolvesChainsStarsAndRings) {
  std::mt19937 random(7);
  for (const Example& example : {Example{{6}, {}}, Example{{6, 6}, {}}, Example{{6, 6}, {{0, 1}}},
                                 Example{{6, 6, 6, 8}, {{0, 3}, {1, 3}, {2, 3}}},
                                 Example{{6, 8, 6, 22}, {{0, 1}, {1, 2}, {2, 3}, {0, 3}}},
                                 Example{{10, 6, 6, 6, 6}, {{0, 4}, {0, 2}, {1, 3}}},
                                 Example{{1, 5, 9, 7}, {{0, 1}, {1, 2}, {2, 3}, {0, 3}}}})
    EXPECT_LT(residual_of(example, random), kRounding);
}

TEST(BlockSystem, FactorsServeAnyNumberOfRightSides) {
  std::mt19937 random(5);
  Number number(-1, 1);
  BlockSystem system = filled({{6, 8, 6, 22}, {{0, 1}, {1, 2}, {2, 3}, {0, 3}}}, random);
  const Eigen::MatrixXd K = whole(system).first;
  system.factor();
  for (int i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < system.count(); ++k)
      for (double& each : system.right_side(k)) each = number(random);
    const Eigen::VectorXd b = whole(system).second;
    system.solve();
    EXPECT_LT((K * whole(system).second - b).norm() / b.norm(), kRounding);
  }
}

// A body whose largest entry of a column is not on the diagonal.
TEST(BlockSystem, ChangesRowsWhereADiagonalVanishes) {
  BlockSystem system;
  system.add_block(6);
  system.add_block(6);
  system.set_zero();
  system.couple(0, 1);
  // Rows in reverse: x_i of the first block is its b_(5 - i), less half of that of the second.
  for (Eigen::Index i = 0; i < 6; ++i) {
    system.block(0, 0)(i, 5 - i) = system.block(1, 1)(i, i) = 1;
    system.block(0, 1)(i, 5 - i) = 0.5;
    system.right_side(0)[i] = static_cast<double>(i);
    system.right_side(1)[i] = 10.0 * static_cast<double>(i);
  }
  system.factor();
  system.solve();
  for (Eigen::Index i = 0; i < 6; ++i) {
    EXPECT_EQ(system.right_side(1)[i], 10.0 * static_cast<double>(i));
    EXPECT_EQ(system.right_side(0)[i], static_cast<double>(5 - i) - 5.0 * static_cast<double>(i));
  }
}

// Systems whose memory begins at other multiples of 16 bytes, as a heap of many sizes gives them.
TEST(BlockSystem, HasTheSameBitsWhereverItsMemoryIs) {
  const auto solution = [] {
    std::mt19937 random(11);
    BlockSystem system =
        filled({{10, 6, 8, 6}, {{1, 0}, {2, 0}, {2, 1}, {3, 0}, {3, 1}, {3, 2}}}, random);
    system.factor();
    system.solve();
    return std::make_pair(whole(system).second, std::move(system));
  };
  const auto first = solution();
  // 48 bytes each, with those of the heap itself.
  std::vector<std::unique_ptr<std::array<double, 4>>> between;
  std::vector<std::pair<Eigen::VectorXd, BlockSystem>> all;
  for (int i = 0; i < 32; ++i) {
    for (int k = 0; k < i % 3; ++k) between.push_back(std::make_unique<std::array<double, 4>>());
    all.push_back(solution());
    EXPECT_EQ(all.back().first, first.first) << "system " << i;
  }
}

}  // namespace
}  // namespace gurney
