#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "studies/statistics/fragility.h"
#include "tests/studies/statistics/synthetic.h"
#include "tests/support/expect_error.h"

namespace gurney::statistics {
namespace {

TEST(FitCheck, FindsNothingWrongWithExactFractions) {
  std::vector<Stripe> stripes;
  for (const double score : {-1.0, 0.0, 0.5, 2.0})
    stripes.push_back({std::exp(score), 100, 100 * normal_cdf(score)});
  const auto p = p_of_fit(stripes, 99);
  ASSERT_TRUE(p);
  EXPECT_GT(*p, 0.99);
}

// A curve with two plateaus is none.
TEST(FitCheck, FindsACurveThatIsNotLognormal) {
  const auto p =
      p_of_fit({{1, 100, 0}, {2, 100, 50}, {4, 100, 50}, {8, 100, 50}, {16, 100, 100}}, 999);
  ASSERT_TRUE(p);
  EXPECT_EQ(*p, 1e-3);  // none of 999
}

// Under the curve itself p is uniform: of 200 repeats 10 are below 0.05; 4.5 binomial standard
// deviations are 13.9.
TEST(FitCheck, SimulatedProbabilityIsUniformForSmallCounts) {
  const SyntheticStudy study{.records = 8, .levels = {0.5, 0.7, 1, 1.4, 2}};
  int small = 0, half = 0, fitted = 0;
  for (std::uint64_t repeat = 0; repeat < 200; ++repeat) {
    const auto p = p_of_fit(StripeTable(study.outcomes(repeat)).stripes(), 199, repeat);
    if (!p) continue;
    ++fitted;
    small += *p <= 0.05;
    half += *p <= 0.5;
  }
  EXPECT_GT(fitted, 180);
  EXPECT_NEAR(small, 0.05 * fitted, 13.9);
  EXPECT_NEAR(half, 0.5 * fitted, 31.8);
}

TEST(FitCheck, NeedsAFitAndThreeStripes) {
  EXPECT_FALSE(p_of_fit({{1, 10, 2}, {2, 10, 8}}));
  EXPECT_FALSE(p_of_fit({{1, 10, 0}, {2, 10, 0}, {3, 10, 0}}));
}

TEST(Isotonic, PoolsAdjacentViolators) {
  EXPECT_EQ(isotonic({1, 3, 2, 4}, {1, 1, 1, 1}), (std::vector<double>{1, 2.5, 2.5, 4}));
  EXPECT_EQ(isotonic({3, 2, 1}, {1, 1, 1}), (std::vector<double>{2, 2, 2}));
  EXPECT_EQ(isotonic({3, 1}, {1, 3}), (std::vector<double>{1.5, 1.5}));
  EXPECT_TRUE(isotonic({}, {}).empty());
  EXPECT_ERROR(isotonic({1, 2}, {1, 0}), "weights[1] = 0 must be > 0");
  EXPECT_ERROR(isotonic({1}, {}), "1 values have 0 weights");
}

// max over s <= i of min over t >= i of the mean of s to t (Barlow et al. 1972), which
// shares nothing with pooling.
TEST(Isotonic, AgreesWithTheMaxMinFormula) {
  const auto stripes = StripeTable(SyntheticStudy{.records = 8}.outcomes(2)).stripes();
  const std::vector<double> curve = isotonic_curve(stripes);
  for (std::size_t i = 0; i < stripes.size(); ++i) {
    double best = 0;
    for (std::size_t s = 0; s <= i; ++s) {
      double least = 1, hits = 0, runs = 0;
      for (std::size_t t = s; t < stripes.size(); ++t) {
        hits += stripes[t].exceeded, runs += stripes[t].runs;
        if (t >= i) least = std::min(least, hits / runs);
      }
      best = std::max(best, least);
    }
    EXPECT_NEAR(curve[i], best, 1e-15);
  }
}

}  // namespace
}  // namespace gurney::statistics
