#include "studies/statistics/two_groups.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "studies/statistics/special.h"
#include "tests/studies/statistics/synthetic.h"

namespace gurney::statistics {
namespace {

TEST(SignTest, IsExact) {
  EXPECT_DOUBLE_EQ(sign_test(0, 5), 2 / 32.0);
  EXPECT_DOUBLE_EQ(sign_test(1, 5), 2 * 7 / 64.0);
  EXPECT_EQ(sign_test(3, 3), 1);
  EXPECT_EQ(sign_test(0, 0), 1);
}

TEST(PairedDifference, CountsARecordOnce) {
  // Records 1 and 2 are in both; record 1 twice in b.
  const auto result =
      paired_difference({{1, 1}, {4, 2}, {100, 3}}, {{2, 1}, {4, 1}, {5, 2}, {9, 7}});
  EXPECT_EQ(result.pairs, 2);
  EXPECT_EQ(result.mean_a, 2.5);
  EXPECT_EQ(result.mean_b, 4);
  EXPECT_EQ(result.difference, 1.5);  // of 2 and 1
  // t with one degree at 0.975: tan(0.475 pi); s = sqrt(0.5)
  EXPECT_NEAR(result.interval.high, 1.5 + std::tan(0.475 * M_PI) * 0.5, 1e-9);
  EXPECT_EQ(result.p_permutation, 0.5);  // both signs as they are, or both turned, of 4
  EXPECT_EQ(result.rises, 2);
  EXPECT_EQ(result.p_sign, 0.5);
}

// Darwin's maize, 15 pairs: Fisher (1935) counted 863 sums as large among 32768 on one side, so
// both sides have 1726.
TEST(PairedDifference, AgreesWithFishersCountForDarwinsMaize) {
  std::vector<Measured> zero, differences;
  for (const double d : {49, -67, 8, 16, 6, 23, 28, 41, 14, 29, 56, 24, 75, 60, -48}) {
    zero.push_back({0, zero.size()});
    differences.push_back({d, differences.size()});
  }
  EXPECT_DOUBLE_EQ(paired_difference(zero, differences).p_permutation, 1726 / 32768.0);
}

// 30 pairs are too many to enumerate; for normal differences the test is Student's t nearly, and
// the share of 99999 flips errs by 4.5 sqrt(p q / 99999).
TEST(PairedDifference, DrawsFlipsForManyRecords) {
  std::vector<Measured> a, b;
  for (std::size_t i = 0; i < 30; ++i) {
    a.push_back({0, i});
    b.push_back({i % 2 == 0 ? 1.0 : -1.0, i});
  }
  b[1].value = b[3].value = b[5].value = b[7].value = 1;  // 19 of 30 rise
  const auto result = paired_difference(a, b);
  const double exact = sign_test(19, 11);  // differences of one size make it the sign test
  EXPECT_NEAR(result.p_permutation, exact, 4.5 * std::sqrt(exact * (1 - exact) / 99999) + 1e-5);
  EXPECT_EQ(result.p_sign, exact);
}

// No event on either side, and the same difference in each pair: Student's interval would have no
// width.
TEST(PairedDifference, HasNoIntervalWithoutScatter) {
  for (const double shift : {0.0, 0.1}) {
    std::vector<Measured> a, b;
    for (std::size_t i = 0; i < 20; ++i) {
      a.push_back({0.3 * static_cast<double>(i) * (shift > 0), i});
      b.push_back({a.back().value + shift, i});
    }
    const auto result = paired_difference(a, b);
    EXPECT_NEAR(result.difference, shift, 1e-12);
    EXPECT_EQ(result.interval.low, -std::numeric_limits<double>::infinity());
    EXPECT_EQ(result.interval.high, std::numeric_limits<double>::infinity());
  }
}

TEST(PairedDifference, KnowsNothingWithoutPairs) {
  const auto result = paired_difference({{1, 1}}, {{1, 2}});
  EXPECT_EQ(result.pairs, 0);
  EXPECT_EQ(result.p_permutation, 1);
  EXPECT_EQ(result.interval.high, std::numeric_limits<double>::infinity());
  EXPECT_EQ(paired_difference({{1, 1}}, {{1, 1}}).p_permutation, 1);
}

/// p of the likelihood ratio by chi-squared with 2 degrees, where runs are independent.
double p_of_independent_runs(const FragilityComparison& result) {
  return chi_squared_survival(result.likelihood_ratio, 2);
}

// Under one curve 5 % of 200 repeats are below 0.05: 10, and 4.5 binomial standard deviations are
// 13.9. Runs of a record are alike here, which the chi-squared does not know.
TEST(CompareFragilities, HoldsItsLevelWhereRecordsAreShared) {
  int rejected = 0, rejected_independent = 0;
  for (std::uint64_t repeat = 0; repeat < 200; ++repeat) {
    const SyntheticStudy study{.records = 15, .levels = {0.5, 0.7, 1, 1.4, 2}, .correlation = 0.6};
    const auto result =
        compare_fragilities(study.outcomes(2 * repeat), study.outcomes(2 * repeat + 1), 99, repeat);
    ASSERT_TRUE(result.p_permutation);
    EXPECT_EQ(result.pairs, 15);
    rejected += *result.p_permutation <= 0.05;
    rejected_independent += p_of_independent_runs(result) <= 0.05;
  }
  EXPECT_NEAR(rejected, 10, 13.9);
  EXPECT_GT(rejected_independent, 24);
}

TEST(CompareFragilities, HoldsItsLevelForIndependentRuns) {
  int rejected = 0;
  for (std::uint64_t repeat = 0; repeat < 1000; ++repeat) {
    const SyntheticStudy study{.levels = {0.5, 0.7, 1, 1.4, 2}};
    rejected += p_of_independent_runs(compare_fragilities(
                    study.outcomes(2 * repeat), study.outcomes(2 * repeat + 1), 0)) <= 0.05;
  }
  EXPECT_NEAR(rejected, 50, 31);  // 4.5 binomial standard deviations
}

TEST(CompareFragilities, FindsADifferenceAndTakesSeparatedData) {
  const SyntheticStudy weak{}, strong{.curve = {1.6, 0.4}};
  const auto result = compare_fragilities(weak.outcomes(1), strong.outcomes(2));
  EXPECT_LT(p_of_independent_runs(result), 1e-6);
  EXPECT_EQ(*result.p_permutation, 1e-3);
  std::vector<Observation> never{{1, false, 0}, {1, false, 1}},
      always{{1, true, 10}, {1, true, 11}};
  const auto extreme = compare_fragilities(never, always);
  EXPECT_NEAR(extreme.likelihood_ratio, 8 * std::log(2.0), 1e-12);  // 0 + 0 - 4 ln 1/2, doubled
  EXPECT_FALSE(extreme.p_permutation);
}

// Exact capacities are normal in their logarithms: -2 ln L = n ln(2 pi s^2) + n with the mean
// square s^2 about the mean, which leaves n_a ln(s^2 / s_a^2) + n_b ln(s^2 / s_b^2).
TEST(CompareCapacities, OfExactOnesHasTheRatioOfTheNormalLaw) {
  std::vector<Capacity> a, b;
  std::vector<double> of_a, of_b, of_both;
  for (std::size_t i = 0; i < 12; ++i) {
    const double x = 0.3 * std::sin(1.0 + static_cast<double>(i)),
                 y = 0.8 + 0.5 * std::cos(2.0 * static_cast<double>(i));
    a.push_back({i, std::exp(x), std::exp(x)});
    b.push_back({i, std::exp(y), std::exp(y)});
    of_a.push_back(x);
    of_b.push_back(y);
  }
  of_both = of_a;
  of_both.insert(of_both.end(), of_b.begin(), of_b.end());
  const auto square = [](const std::vector<double>& x) {
    double mean = 0, sum = 0;
    for (const double each : x) mean += each / static_cast<double>(x.size());
    for (const double each : x) sum += (each - mean) * (each - mean);
    return sum / static_cast<double>(x.size());
  };
  const auto found = compare_capacities(a, b, 99);
  const double expected =
      12 * std::log(square(of_both) / square(of_a)) + 12 * std::log(square(of_both) / square(of_b));
  EXPECT_NEAR(found.likelihood_ratio, expected, 1e-8 * expected);
  EXPECT_EQ(found.pairs, 12);
  EXPECT_LE(*found.p_permutation, 0.02);
  EXPECT_EQ(*compare_capacities(a, a, 99).p_permutation, 1);
}

TEST(Holm, AdjustsInStepsDown) {
  const auto adjusted = holm_adjusted({0.01, 0.04, 0.03, 0.005});
  EXPECT_THAT(adjusted, testing::Pointwise(testing::DoubleNear(1e-15), {0.03, 0.06, 0.06, 0.02}));
  EXPECT_EQ(holm_adjusted({0.9, 0.8}), (std::vector<double>{1, 1}));
  const auto with_gap = holm_adjusted({std::nan(""), 0.02, 0.5});
  EXPECT_TRUE(std::isnan(with_gap[0]));
  EXPECT_EQ(with_gap[1], 0.04);
}

}  // namespace
}  // namespace gurney::statistics
