#include "engine/solver/solve6.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <random>

namespace gurney {
namespace {

// Whatever rows are swapped: entries of random size, some of them zero.
TEST(Solve6, GivesTheBitsOfEigen) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 20000; ++trial) {
    Matrix6 a;
    Vector6 b;
    for (int i = 0; i < 6; ++i) {
      b[i] = normal(random);
      for (int j = 0; j < 6; ++j)
        a(i, j) =
            trial % 3 == 0 && random() % 3 == 0 ? 0 : normal(random) * std::exp2(i * (trial % 4));
    }
    const Vector6 expected = a.partialPivLu().solve(b), found = solve6(a, b);
    for (int i = 0; i < 6; ++i)
      EXPECT_TRUE(std::isnan(expected[i]) || found[i] == expected[i]) << trial;
  }
}

}  // namespace
}  // namespace gurney
