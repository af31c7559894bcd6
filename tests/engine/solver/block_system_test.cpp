#include "engine/solver/block_system.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <array>
#include <cstdint>
#include <memory>
#include <random>

namespace gurney {
namespace {

/// Bodies of these sizes with masses on the diagonal, and slopes that are not symmetric between the pairs.
struct Example {
  std::vector<Eigen::Index> sizes;
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
};

/// Norm of K x - b, with K and b as they were before, over that of b.
double residual_of(const Example& example, std::mt19937& random) {
  std::uniform_real_distribution<double> number(-1, 1);
  BlockSystem system;
  std::vector<Eigen::Index> begin;
  for (const Eigen::Index size : example.sizes) {
    begin.push_back(system.size());
    EXPECT_EQ(system.add_block(size), begin.size() - 1);
  }
  system.set_zero();
  auto K = system.matrix();
  const auto fill = [&](std::size_t a, std::size_t b, double size) {
    for (Eigen::Index i = 0; i < example.sizes[a]; ++i)
      for (Eigen::Index j = 0; j < example.sizes[b]; ++j)
        K(begin[a] + i, begin[b] + j) += size * number(random);
  };
  for (std::size_t k = 0; k < example.sizes.size(); ++k) {
    fill(k, k, 1);
    for (Eigen::Index i = 0; i < example.sizes[k]; ++i) K(begin[k] + i, begin[k] + i) += 60;
  }
  for (const auto& [a, b] : example.pairs) {
    system.couple(a, b);
    fill(a, b, 1);
    fill(b, a, 1);
  }
  auto x = system.right_side();
  for (double& each : x) each = number(random);
  const Eigen::MatrixXd matrix = K;
  const Eigen::VectorXd b = x;
  system.solve();
  return (matrix * x - b).norm() / b.norm();
}

// Rounding of some 100 operations an entry; diagonals dominate.
constexpr double kRounding = 1e-13;

TEST(BlockSystem, SolvesChainsStarsAndRings) {
  std::mt19937 random(7);
  for (const Example& example : {Example{{6}, {}}, Example{{6, 6}, {}}, Example{{6, 6}, {{0, 1}}},
                                 Example{{6, 6, 6, 8}, {{0, 3}, {1, 3}, {2, 3}}},
                                 Example{{6, 8, 6, 22}, {{0, 1}, {1, 2}, {2, 3}, {0, 3}}},
                                 Example{{10, 6, 6, 6, 6}, {{0, 4}, {0, 2}, {1, 3}}}})
    EXPECT_LT(residual_of(example, random), kRounding);
}

// Systems whose memory begins at other multiples of 16 bytes, as a heap of many sizes gives them.
TEST(BlockSystem, HasTheSameBitsWhereverItsMemoryIs) {
  const auto solution = [] {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> number(-1, 1);
    BlockSystem system;
    for (const Eigen::Index size : {10, 6, 8, 6}) system.add_block(size);
    system.set_zero();
    for (std::size_t a = 0; a < 4; ++a)
      for (std::size_t b = 0; b < a; ++b) system.couple(a, b);
    auto K = system.matrix();
    for (double& entry : K.reshaped()) entry = number(random);
    K.diagonal().array() += 60;
    for (double& entry : system.right_side()) entry = number(random);
    const auto begins = [](const double* at) {
      return reinterpret_cast<std::uintptr_t>(at) % EIGEN_MAX_ALIGN_BYTES;
    };
    EXPECT_EQ(begins(system.matrix().data()), 0);
    EXPECT_EQ(begins(system.right_side().data()), 0);
    system.solve();
    return std::make_pair(Eigen::VectorXd(system.right_side()), std::move(system));
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
