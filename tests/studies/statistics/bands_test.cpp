#include "studies/statistics/bands.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "studies/statistics/quantiles.h"
#include "studies/statistics/special.h"
#include "tests/studies/statistics/synthetic.h"
#include "tests/support/expect_error.h"

namespace gurney::statistics {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kRepeats = 1000;

/// The counts of `kRepeats` that a true 95 % interval gives with a probability of 99 %: 932 to 967.
Interval accepted_counts() {
  Interval accepted{0, 0};
  while (binomial_cdf(static_cast<int>(accepted.low), kRepeats, 0.95) < 0.005) ++accepted.low;
  accepted.high = accepted.low;
  while (binomial_cdf(static_cast<int>(accepted.high), kRepeats, 0.95) < 0.995) ++accepted.high;
  return accepted;
}

struct Coverage {
  std::vector<int> of_curve, percentile_of_curve;
  int theta = 0, beta = 0, without_fit = 0;
};

const std::vector<double> kProbabilities{0.05, 0.16, 0.5, 0.84, 0.95};

Coverage coverage(const SyntheticStudy& study, int repeats = kRepeats) {
  std::vector<double> im;
  for (const double p : kProbabilities) im.push_back(study.curve.quantile(p));
  Coverage covered;
  covered.of_curve.resize(im.size());
  covered.percentile_of_curve.resize(im.size());
  for (int i = 0; i < repeats; ++i) {
    const std::uint64_t repeat = static_cast<std::uint64_t>(i);
    const StripeTable table(study.outcomes(repeat));
    const FragilityBand band = fragility_band(table, im, {.resamples = 199, .seed = repeat});
    covered.without_fit += band.status != FragilityStatus::kFitted;
    for (std::size_t j = 0; j < im.size(); ++j) {
      covered.of_curve[j] += band.of_curve[j].contains(kProbabilities[j]);
      covered.percentile_of_curve[j] += band.percentile_of_curve[j].contains(kProbabilities[j]);
    }
    covered.theta += band.theta.contains(study.curve.theta);
    covered.beta += band.beta.contains(study.curve.beta);
  }
  return covered;
}

void expect_covers(const SyntheticStudy& study) {
  const Interval accepted = accepted_counts();
  const Coverage covered = coverage(study);
  EXPECT_EQ(covered.without_fit, 0);
  for (std::size_t i = 0; i < kProbabilities.size(); ++i) {
    EXPECT_TRUE(accepted.contains(covered.of_curve[i]))
        << covered.of_curve[i] << " of " << kRepeats << " at " << kProbabilities[i];
  }
  EXPECT_TRUE(accepted.contains(covered.theta)) << "theta: " << covered.theta;
  EXPECT_TRUE(accepted.contains(covered.beta)) << "beta: " << covered.beta;
}

TEST(FragilityBand, CoversWhereRunsAreIndependent) { expect_covers({.correlation = 0}); }

TEST(FragilityBand, CoversWhereRunsOfARecordAreAlike) { expect_covers({.correlation = 0.5}); }

TEST(FragilityBand, CoversWhereTheRecordDecides) { expect_covers({.correlation = 1}); }

// The reason for the better band: plain percentiles of the same resamples are too narrow.
TEST(FragilityBand, PercentilesWouldNotCover) {
  const Coverage covered = coverage({.records = 20, .correlation = 0.5}, 200);
  for (const int count : covered.percentile_of_curve) EXPECT_LT(count, 200 * 0.95);
  EXPECT_LT(covered.percentile_of_curve.front(), 200 * 0.9);
}

TEST(FragilityBand, IsTheSameForTheSameSeed) {
  const StripeTable table(SyntheticStudy{}.outcomes(1));
  const auto one = fragility_band(table, {0.7, 1}, {.resamples = 99, .seed = 5});
  const auto two = fragility_band(table, {1}, {.resamples = 99, .seed = 5});
  const auto other = fragility_band(table, {1}, {.resamples = 99, .seed = 6});
  EXPECT_EQ(one.of_curve[1].low, two.of_curve[0].low);
  EXPECT_NE(one.percentile_of_curve[1].low, other.percentile_of_curve[0].low);
  EXPECT_EQ(one.curves.size(), 99u);
  EXPECT_LT(one.percentile_theta.low, one.curves[0].theta);
  EXPECT_GT(one.percentile_theta.high, one.curves[0].theta);
  EXPECT_LT(one.theta.low, one.percentile_theta.high);
}

// One method for both: the interval of theta is where the band holds P = 0.5. Ends are found to
// 2^-40 of a bracket.
TEST(FragilityBand, HoldsOneHalfWithinTheIntervalOfTheta) {
  const StripeTable table(SyntheticStudy{.records = 11, .correlation = 0.5}.outcomes(3));
  const Interval theta = fragility_band(table, {}, {.resamples = 199}).theta;
  const auto band = fragility_band(table, {theta.low, theta.high}, {.resamples = 199}).of_curve;
  EXPECT_NEAR(band[0].high, 0.5, 1e-9);
  EXPECT_NEAR(band[1].low, 0.5, 1e-9);
}

// Two of three records at the higher level, one at the lower: the slope could be 0, so theta could
// be anywhere.
TEST(FragilityBand, BoundsThetaOnlyWhereTheSlopeIsNotZero) {
  std::vector<Observation> seen;
  for (std::size_t record = 0; record < 6; ++record) {
    seen.push_back({1, record < 2, record});
    seen.push_back({1.1, record % 2 == 0, record});
  }
  const auto band = fragility_band(StripeTable(seen), {});
  EXPECT_EQ(band.theta.low, 0);
  EXPECT_EQ(band.theta.high, kInfinity);
}

// Three records of two runs: 1 of 27 resamples holds only the record that never exceeds, and so on.
TEST(FragilityBand, CountsResamplesWithoutACurve) {
  const StripeTable table(
      {{1, false, 0}, {2, false, 0}, {1, true, 1}, {2, true, 1}, {1, false, 2}, {2, true, 2}});
  const auto band = fragility_band(table, {0.5, 1, 2, 4}, {.resamples = 2700});
  ASSERT_EQ(band.status, FragilityStatus::kFitted);
  // Each kind's number is binomial; 4.5 standard deviations are allowed. All exceed: 1, 1, 1 only.
  // None exceeds: 0, 0, 0 only. Separated: 2, 2, 2; quasi-separated: 0 and 2 or 1 and 2, 12 of 27.
  EXPECT_NEAR(band.one_sided, 200, 4.5 * std::sqrt(200 * 25 / 27.0));
  EXPECT_NEAR(band.separated, 1300, 4.5 * std::sqrt(1300 * 14 / 27.0));
  // 0 and 1 alone: the same fraction at both levels, 6 of 27
  EXPECT_NEAR(band.not_increasing, 600, 4.5 * std::sqrt(600 * 21 / 27.0));
  EXPECT_EQ(
      band.one_sided + band.separated + band.not_increasing + static_cast<int>(band.curves.size()),
      2700);
  for (const Interval& ends : band.of_curve) {
    EXPECT_TRUE(ends.low >= 0 && ends.high <= 1 && ends.low <= ends.high);
  }
  EXPECT_GT(band.beta.low, 0);
  EXPECT_EQ(band.percentile_theta.low, 0);
  EXPECT_EQ(band.percentile_theta.high, kInfinity);
}

TEST(FragilityBand, FallsBackWithoutAFit) {
  std::vector<Observation> seen;
  for (std::size_t record = 0; record < 40; ++record)
    for (const double im : {0.5, 1.0}) seen.push_back({im, false, record});
  const auto band = fragility_band(StripeTable(seen), {0.7, 1, 2});
  EXPECT_EQ(band.status, FragilityStatus::kNoneExceeds);
  // 0 of 40: 1 - 0.025^(1/40)
  const double upper = 1 - std::pow(0.025, 1 / 40.0);
  EXPECT_NEAR(band.of_curve[0].high, upper, 1e-12);
  EXPECT_NEAR(band.of_curve[1].high, upper, 1e-12);
  EXPECT_EQ(band.of_curve[2].high, 1);  // nothing was run there
  for (const Interval& ends : band.of_curve) EXPECT_EQ(ends.low, 0);
  EXPECT_EQ(band.theta.high, kInfinity);
}

TEST(FragilityBand, RefusesOptionsOutOfRange) {
  const StripeTable table(SyntheticStudy{}.outcomes(1));
  EXPECT_ERROR(fragility_band(table, {1}, {.confidence = 1}), "confidence = 1 must be in (0, 1)");
  EXPECT_ERROR(fragility_band(table, {1}, {.resamples = 0}), "resamples = 0 must be >= 1");
  EXPECT_ERROR(fragility_band(table, {-1}), "im = -1 must be > 0");
}

// 8 of 10: the published 95 % interval is 0.444 to 0.975.
TEST(ProportionInterval, IsThatOfClopperAndPearson) {
  const Interval ends = proportion_interval(8, 10);
  EXPECT_NEAR(ends.low, 0.4439, 5e-5);
  EXPECT_NEAR(ends.high, 0.9748, 5e-5);
  EXPECT_EQ(proportion_interval(0, 0).low, 0);
  EXPECT_EQ(proportion_interval(0, 0).high, 1);
}

TEST(DistributionFreeBand, CoversAtLeastAsOftenAsItSays) {
  const SyntheticStudy study{.records = 10, .correlation = 1};
  std::vector<int> covered(kProbabilities.size());
  for (std::uint64_t repeat = 0; repeat < kRepeats; ++repeat) {
    std::vector<double> im;
    for (const double p : kProbabilities) im.push_back(study.curve.quantile(p));
    const auto band = distribution_free_band(StripeTable(study.outcomes(repeat)), im);
    for (std::size_t i = 0; i < im.size(); ++i) covered[i] += band[i].contains(kProbabilities[i]);
  }
  for (const int count : covered) EXPECT_GE(count, accepted_counts().low);
}

TEST(ProfileIntervals, EndWhereTheLikelihoodRatioIsTheQuantile) {
  const StripeTable table(SyntheticStudy{}.outcomes(4));
  const ProbitFit fit = fit_probit(table.stripes());
  const auto intervals = profile_intervals(table);
  ASSERT_TRUE(intervals);
  for (const bool of_beta : {false, true}) {
    for (const bool upper : {false, true}) {
      const Interval ends = of_beta ? intervals->beta : intervals->theta;
      const double fixed = upper ? ends.high : ends.low;
      double best = -kInfinity;  // over the other parameter, on a grid of 1e-4 of a standard error
      for (int i = -20000; i <= 20000; ++i) {
        const double other = std::exp(2e-5 * i);
        const double theta = of_beta ? fit.curve().theta * other : fixed;
        const double beta = of_beta ? fixed : fit.curve().beta * other;
        const auto at = binomial_likelihood(table.stripes(), {1 / beta, -std::log(theta) / beta});
        best = std::max(best, at.value);
      }
      EXPECT_NEAR(2 * (fit.log_likelihood - best), 3.841458820694124, 1e-6);
    }
  }
}

TEST(ProfileIntervals, CoverWhereRunsAreIndependentAndWithRecords) {
  for (const double correlation : {0.0, 0.5}) {
    const SyntheticStudy study{.correlation = correlation};
    int theta = 0, beta = 0, theta_plain = 0;
    for (std::uint64_t repeat = 0; repeat < kRepeats; ++repeat) {
      const StripeTable table(study.outcomes(repeat));
      const auto intervals = profile_intervals(table, 0.95, correlation > 0);
      theta += intervals->theta.contains(study.curve.theta);
      beta += intervals->beta.contains(study.curve.beta);
      if (correlation > 0)
        theta_plain += profile_intervals(table)->theta.contains(study.curve.theta);
    }
    EXPECT_TRUE(accepted_counts().contains(theta)) << theta;
    EXPECT_TRUE(accepted_counts().contains(beta)) << beta;
    EXPECT_LT(theta_plain, 900);  // records ignored: too narrow
  }
}

TEST(ProfileIntervals, SayWhatTheDataDoNotBound) {
  // A rise from 1 to 2 in 4 is no evidence of a rise.
  const StripeTable table({{1, true, 0},
                           {1, false, 1},
                           {1, false, 2},
                           {1, false, 3},
                           {2, true, 4},
                           {2, true, 5},
                           {2, false, 6},
                           {2, false, 7}});
  const auto intervals = profile_intervals(table);
  ASSERT_TRUE(intervals);
  EXPECT_EQ(intervals->beta.high, kInfinity);
  EXPECT_GT(intervals->beta.low, 0);
  EXPECT_EQ(intervals->theta.high, kInfinity);
  EXPECT_FALSE(profile_intervals(StripeTable({{1, true, 0}})));
}

TEST(Quantiles, AreThoseOfNumpy) {
  EXPECT_EQ(quantile_of({4, 1, 3, 2}, 0.5), 2.5);
  EXPECT_EQ(quantile_of({4, 1, 3, 2}, 0), 1);
  EXPECT_EQ(quantile_of({4, 1, 3, 2}, 1), 4);
  EXPECT_DOUBLE_EQ(quantile_of({4, 1, 3, 2}, 0.1), 1.3);
  EXPECT_EQ(quantile_of({1, kInfinity, kInfinity}, 0.9), kInfinity);
  EXPECT_EQ(moments_of({1, 2, 3}).variance, 1);
  EXPECT_EQ(ranks_of({5, 1, 5, 2}), (std::vector<double>{3.5, 1, 3.5, 2}));
}

}  // namespace
}  // namespace gurney::statistics
