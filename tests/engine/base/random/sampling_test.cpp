#include "engine/base/random/sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/random/sobol.hpp>
#include <cmath>
#include <set>
#include <vector>

#include "engine/base/random/normal_draw.h"
#include "studies/statistics/special.h"
#include "tests/support/expect_error.h"

namespace gurney {
namespace {

TEST(LatinHypercube, HasOneDrawInEachCell) {
  for (const std::uint64_t n : {1, 2, 3, 5, 16, 17, 100, 1000, 1025}) {
    std::vector<int> cells(n);
    for (std::uint64_t i = 0; i < n; ++i) {
      const double u = latin_hypercube_draw(7, 3, i, n);
      ASSERT_TRUE(u > 0 && u < 1);
      ++cells[static_cast<std::size_t>(u * static_cast<double>(n))];
    }
    EXPECT_EQ(std::count(cells.begin(), cells.end(), 1), static_cast<std::ptrdiff_t>(n)) << n;
  }
}

// Every cell is as likely for every draw, over 4000 variables. Sums of permutation matrices have
// fixed margins: Pearson's sum is n / (n - 1) times chi-squared with (n - 1)^2 degrees. 1e-4 in the
// tail.
TEST(LatinHypercube, PermutesEvenly) {
  for (const std::uint64_t n : {2, 3, 7, 16}) {
    std::vector<double> counts(n * n);
    const std::uint64_t variables = 4000;
    for (std::uint64_t v = 0; v < variables; ++v)
      for (std::uint64_t i = 0; i < n; ++i)
        ++counts[i * n + static_cast<std::size_t>(latin_hypercube_draw(1, v, i, n) *
                                                  static_cast<double>(n))];
    double chi = 0;
    const double expected = static_cast<double>(variables) / static_cast<double>(n);
    for (const double count : counts) chi += std::pow(count - expected, 2) / expected;
    chi *= static_cast<double>(n - 1) / static_cast<double>(n);
    EXPECT_GT(statistics::chi_squared_survival(chi, std::pow(static_cast<double>(n - 1), 2)), 1e-4)
        << n;
  }
}

// Correlations of 40 pairs of variables have a standard deviation of 1 / sqrt(n - 1); their squares
// times n - 1 sum to chi-squared with 40 degrees.
TEST(LatinHypercube, VariablesAndSeedsAreIndependent) {
  const std::uint64_t n = 500;
  double sum = 0;
  for (std::uint64_t v = 0; v < 40; ++v) {
    double product = 0;
    for (std::uint64_t i = 0; i < n; ++i)
      product += (latin_hypercube_draw(1, v, i, n) - 0.5) *
                 (latin_hypercube_draw(1 + v % 2, v + 1, i, n) - 0.5);
    sum += std::pow(product / static_cast<double>(n) * 12, 2) * static_cast<double>(n - 1);
  }
  EXPECT_GT(statistics::chi_squared_survival(sum, 40), 1e-4);
  EXPECT_LT(statistics::chi_squared_survival(sum, 40), 1 - 1e-4);
}

// A mean over n strata of a linear function has the variance 1 / (12 n^3), not 1 / (12 n).
TEST(LatinHypercube, ReducesTheVarianceOfMeans) {
  double worst = 0;
  for (std::uint64_t v = 0; v < 50; ++v) {
    double sum = 0;
    for (std::uint64_t i = 0; i < 100; ++i) sum += latin_hypercube_draw(2, v, i, 100);
    worst = std::max(worst, std::abs(sum / 100 - 0.5));
  }
  EXPECT_LT(worst, 5 / std::sqrt(12e6));
}

TEST(LatinHypercube, RefusesDrawsThatAreNone) {
  constexpr std::uint64_t kMost = std::uint64_t{1} << 40;
  EXPECT_ERROR(latin_hypercube_draw(1, 0, 5, 5), "draw 5 must be below the number of draws, 5");
  EXPECT_GT(latin_hypercube_draw(1, 0, 0, kMost), 0);
  EXPECT_ERROR(latin_hypercube_draw(1, 0, 0, kMost + 1), "1099511627777 draws are too many");
}

TEST(Sobol, IsBoostsSequenceWithADigitalShift) {
  const std::size_t dimensions = 40;
  boost::random::sobol engine(dimensions);
  std::vector<std::vector<std::uint64_t>> points;
  for (int i = 0; i < 200; ++i) {
    points.emplace_back();
    for (std::size_t d = 0; d < dimensions; ++d) points.back().push_back(engine() >> 12);
  }
  // Boost leaves out the point 0. Differences of points do not know the shift.
  const auto bits = [](double u) { return static_cast<std::uint64_t>(std::ldexp(u, 52)); };
  for (std::uint64_t i = 1; i < 200; ++i)
    for (std::size_t d = 0; d < dimensions; ++d)
      ASSERT_EQ(bits(sobol_draw(9, d, i + 1)) ^ bits(sobol_draw(9, d, i)),
                points[i][d] ^ points[i - 1][d])
          << i << ' ' << d;
}

TEST(Sobol, HasOnePointInEachCellOfEachDimensionAndPairs) {
  for (std::uint64_t d = 0; d < 20; ++d) {
    std::set<int> cells;
    for (std::uint64_t i = 0; i < 256; ++i)
      cells.insert(static_cast<int>(256 * sobol_draw(5, d, i)));
    EXPECT_EQ(cells.size(), 256u) << d;
  }
  std::set<int> squares;  // of the first two dimensions, 16 by 16
  for (std::uint64_t i = 0; i < 256; ++i)
    squares.insert(static_cast<int>(16 * sobol_draw(5, 0, i)) * 16 +
                   static_cast<int>(16 * sobol_draw(5, 1, i)));
  EXPECT_EQ(squares.size(), 256u);
}

TEST(Sobol, ShiftsBySeedAndDimension) {
  std::set<double> firsts;
  for (std::uint64_t seed = 0; seed < 20; ++seed)
    for (std::uint64_t d = 0; d < 20; ++d) firsts.insert(sobol_draw(seed, d, 0));
  EXPECT_EQ(firsts.size(), 400u);
}

TEST(Sampling, RefusesWhatItDoesNotHave) {
  EXPECT_ERROR(latin_hypercube_draw(1, 1, 5, 5), "draw 5 must be below the number of draws, 5");
  EXPECT_ERROR(latin_hypercube_draw(1, 1, 0, 0), "draw 0 must be below the number of draws, 0");
  EXPECT_ERROR(sobol_draw(1, 3667, 0), "variable 3668 is too many for Sobol points: at most 3667");
}

TEST(SaltelliDraw, HalvesOfOneSobolSequence) {
  for (const std::uint64_t input : {0, 1, 2}) {
    EXPECT_EQ(saltelli_draw(4, 3, input, {9, 0}), sobol_draw(4, input, 9));
    EXPECT_EQ(saltelli_draw(4, 3, input, {9, 1}), sobol_draw(4, 3 + input, 9));
    for (const std::uint64_t mixed : {0, 1, 2})
      EXPECT_EQ(saltelli_draw(4, 3, input, {9, 2 + mixed}),
                sobol_draw(4, input + (input == mixed ? 3 : 0), 9));
  }
  EXPECT_ERROR(saltelli_draw(4, 1834, 0, {}),
               "1834 inputs are too many for a Saltelli design: at "
               "most 1833");
  EXPECT_ERROR(saltelli_draw(4, 3, 3, {}), "input 3 must be below 3");
}

}  // namespace
}  // namespace gurney
