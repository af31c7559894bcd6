#include "studies/statistics/capacity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/studies/statistics/synthetic.h"
#include "tests/support/expect_error.h"

namespace gurney::statistics {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Capacity, IsTheFirstExceedanceInAnyOrder) {
  std::vector<Observation> seen{{3, false, 1},   {1, false, 1}, {2, true, 1},  {4, true, 1},
                                {1.5, false, 1}, {1, false, 0}, {5, false, 0}, {1, true, 9}};
  for (int order = 0; order < 2; ++order) {
    const auto capacities = ida_capacities(seen);
    ASSERT_EQ(capacities.size(), 3u);
    EXPECT_EQ(capacities[0].group, 0u);
    EXPECT_EQ(capacities[0].low, 5);
    EXPECT_EQ(capacities[0].high, kInfinity);
    EXPECT_EQ(capacities[1].low, 1.5);
    EXPECT_EQ(capacities[1].high, 2);
    EXPECT_EQ(capacities[1].resurrections, 1);
    EXPECT_EQ(capacities[1].runs, 5);
    EXPECT_EQ(capacities[2].low, 0);
    EXPECT_EQ(capacities[2].high, 1);
    std::reverse(seen.begin(), seen.end());
  }
  EXPECT_ERROR(ida_capacities({{-1, true, 0}}), "im = -1 must be > 0");
}

TEST(Capacity, EachAnalysisCaseOfARecordHasItsOwn) {
  // Two draws of record 4 exceed at 2 and at 8; a record with one case weighs as much as both.
  const auto capacities = ida_capacities(
      {{1, false, 4, 0}, {2, true, 4, 0}, {4, false, 4, 1}, {8, true, 4, 1}, {3, true, 5, 2}});
  ASSERT_EQ(capacities.size(), 3u);
  EXPECT_EQ(capacities[0].high, 2);
  EXPECT_EQ(capacities[1].low, 4);
  EXPECT_EQ(capacities[1].high, 8);
  EXPECT_EQ(capacities[1].resurrections, 0);
  EXPECT_EQ(capacities[0].weight, 0.5);
  EXPECT_EQ(capacities[1].weight, 0.5);
  EXPECT_EQ(capacities[2].weight, 1);
}

std::vector<Capacity> brackets(const std::vector<std::pair<double, double>>& ends) {
  std::vector<Capacity> all;
  for (const auto& [low, high] : ends) all.push_back({all.size(), low, high});
  return all;
}

// Exact capacities: the maximum is at the moments, with n instead of n - 1.
TEST(CapacityFit, IsTheMethodOfMomentsForExactCapacities) {
  const std::vector<double> exact{0.5, 0.8, 1.1, 1.3, 2.0};
  std::vector<std::pair<double, double>> ends;
  for (const double c : exact) ends.emplace_back(c, c);
  const CapacityFit fit = fit_capacities(brackets(ends));
  const auto moments = curve_of_moments(exact);
  ASSERT_TRUE(fit.curve);
  EXPECT_NEAR(fit.curve->theta, moments.theta, 1e-9);
  EXPECT_NEAR(fit.curve->beta, moments.beta * std::sqrt(4 / 5.0), 1e-9);
  // beta^2 / n and 1 / (2 n)
  EXPECT_NEAR(fit.covariance(0, 0), std::pow(fit.curve->beta, 2) / 5, 1e-9);
  EXPECT_NEAR(fit.covariance(1, 1), 0.1, 1e-9);
}

// Brackets of any width go over into exact ones: 1e-6 is a density, 0.05 a series, 0.5 differences
// of probabilities. The middle of a bracket is off by d^2 / 24 of the slope at most.
TEST(CapacityFit, NarrowBracketsAreExactCapacities) {
  const std::vector<double> exact{0.5, 0.8, 1.1, 1.3, 2.0};
  const double theta = curve_of_moments(exact).theta;
  for (const double width : {1e-9, 1e-6, 1e-3, 4e-3, 6e-3, 0.05, 0.3}) {
    std::vector<std::pair<double, double>> ends;
    for (const double c : exact)
      ends.emplace_back(c * std::exp(-width / 2), c * std::exp(width / 2));
    const CapacityFit fit = fit_capacities(brackets(ends));
    ASSERT_TRUE(fit.curve) << width;
    EXPECT_NEAR(fit.curve->theta, theta, 1e-8 + 0.1 * width * width) << width;
  }
}

// Sheppard: a bracket of width d adds d^2 / 12 to the variance of the middles, and the fit
// takes it off again. Fourth order in d / beta = 0.75: 2e-3.
TEST(CapacityFit, DoesNotCountTheWidthOfBracketsAsDispersion) {
  std::vector<std::pair<double, double>> ends;
  std::vector<double> middles;
  const double d = 0.3;
  for (int i = 0; i < 4000; ++i) {
    const double cell = std::floor(0.4 * normal_quantile((i + 0.5) / 4000) / d);
    ends.emplace_back(std::exp(cell * d), std::exp((cell + 1) * d));
    middles.push_back(std::exp((cell + 0.5) * d));
  }
  const CapacityFit fit = fit_capacities(brackets(ends));
  EXPECT_NEAR(fit.curve->beta, 0.4, 2e-3);
  EXPECT_NEAR(fit.curve->theta, 1, 2e-3);
  EXPECT_NEAR(std::pow(curve_of_moments(middles).beta, 2), 0.16 + d * d / 12, 2e-3);
}

// Truncated at the median of 2000 quantiles: half the records never exceed. Their values must not
// matter; sqrt of the mesh's error is far below 1e-3.
TEST(CapacityFit, RecordsThatNeverExceedAreNotForgotten) {
  std::vector<std::pair<double, double>> ends;
  for (int i = 0; i < 2000; ++i) {
    const double c = std::exp(0.4 * normal_quantile((i + 0.5) / 2000));
    c < 1 ? ends.emplace_back(c, c) : ends.emplace_back(1, kInfinity);
  }
  const CapacityFit fit = fit_capacities(brackets(ends));
  EXPECT_EQ(fit.censored, 1000);
  EXPECT_NEAR(fit.curve->theta, 1, 1e-3);
  EXPECT_NEAR(fit.curve->beta, 0.4, 1e-3);
}

// Brackets open on one side are a probit regression.
TEST(CapacityFit, AgreesWithStripesForOneRunOfEachRecord) {
  const std::vector<Stripe> stripes{{0.5, 20, 3}, {1, 20, 9}, {2, 20, 18}};
  std::vector<std::pair<double, double>> ends;
  for (const Stripe& stripe : stripes)
    for (int i = 0; i < 20; ++i)
      i < stripe.exceeded ? ends.emplace_back(0, stripe.im)
                          : ends.emplace_back(stripe.im, kInfinity);
  const CapacityFit fit = fit_capacities(brackets(ends));
  const ProbitFit probit = fit_probit(stripes);
  ASSERT_TRUE(fit.curve);
  EXPECT_NEAR(fit.curve->theta, probit.curve().theta, 1e-8);
  EXPECT_NEAR(fit.curve->beta, probit.curve().beta, 1e-8);
  EXPECT_NEAR(fit.log_likelihood, probit.log_likelihood, 1e-9);
}

TEST(CapacityFit, SaysWhyThereIsNoCurve) {
  using enum FragilityStatus;
  EXPECT_EQ(fit_capacities({}).status, kNoRuns);
  EXPECT_EQ(fit_capacities(brackets({{2, kInfinity}, {3, kInfinity}})).status, kNoneExceeds);
  EXPECT_EQ(fit_capacities(brackets({{0, 1}, {0, 2}})).status, kAllExceed);
  const CapacityFit separated = fit_capacities(brackets({{1, 3}, {2, 4}, {0.5, kInfinity}}));
  EXPECT_EQ(separated.status, kSeparated);
  EXPECT_EQ(separated.low, 2);
  EXPECT_EQ(separated.high, 3);
  EXPECT_EQ(fit_capacities(brackets({{1, 2}, {2, 4}})).status, kQuasiSeparated);
  EXPECT_EQ(fit_capacities(brackets({{2, kInfinity}, {2, kInfinity}, {0, 1}, {0, 1}})).status,
            kNotIncreasing);
  EXPECT_FALSE(fit_capacities(brackets({{1, 2}, {2, 4}})).curve);
}

// Two of four below 2: the likelihood of a step there is 2^-4.
TEST(CapacityFit, HasTheLimitOfTheLikelihoodWhereItIsSeparated) {
  EXPECT_NEAR(fit_capacities(brackets({{1, 2}, {1, 2}, {2, 4}, {2, 5}})).log_likelihood,
              -4 * std::log(2.0), 1e-12);
  EXPECT_EQ(fit_capacities(brackets({{1, 3}, {2, 4}})).log_likelihood, 0);
}

// At 2 the third says nothing, at 3 the first two; the fourth never exceeds and says it up to 4.
TEST(StripesOfCapacities, CountTheCasesWhoseBracketKnows) {
  const auto stripes = stripes_of(brackets({{1, 2}, {2, 3}, {1, 4}, {4, kInfinity}}));
  ASSERT_EQ(stripes.size(), 4);
  const double runs[] = {4, 3, 3, 4}, exceeded[] = {0, 1, 2, 3};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(stripes[i].im, static_cast<double>(i + 1));
    EXPECT_EQ(stripes[i].runs, runs[i]) << i;
    EXPECT_EQ(stripes[i].exceeded, exceeded[i]) << i;
  }
}

TEST(Capacity, ARecordSeenThriceAlikeTellsWhatItTellsOnce) {
  const std::vector<Capacity> once =
      brackets({{1, 1.4}, {1.2, 1.7}, {0.6, 0.8}, {2, 3}, {0.9, 1.2}, {2.5, kInfinity}});
  std::vector<Capacity> thrice;
  for (Capacity each : once) {
    each.weight = 1.0 / 3;
    thrice.insert(thrice.end(), 3, each);
  }
  const CapacityFit a = fit_capacities(once), b = fit_capacities(thrice);
  ASSERT_TRUE(a.curve && b.curve);
  // The same likelihood but for rounding; Newton's method ends within 1e-10 of its maximum.
  EXPECT_NEAR(b.curve->theta, a.curve->theta, 1e-9);
  EXPECT_NEAR(b.curve->beta, a.curve->beta, 1e-9);
  EXPECT_NEAR(b.covariance(0, 0), a.covariance(0, 0), 1e-9);
  const CapacityIntervals of_a = capacity_intervals(once, a, {1}, 0.95);
  const CapacityIntervals of_b = capacity_intervals(thrice, b, {1}, 0.95);
  // Ends are found to 1e-9 of a few standard errors.
  EXPECT_NEAR(of_b.theta.low, of_a.theta.low, 1e-7);
  EXPECT_NEAR(of_b.theta.high, of_a.theta.high, 1e-7);
  EXPECT_NEAR(of_b.beta.high, of_a.beta.high, 1e-6);
}

}  // namespace
}  // namespace gurney::statistics
