#include "studies/statistics/vector_fragility.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/base/random/normal_draw.h"
#include "studies/statistics/fragility.h"
#include "studies/statistics/special.h"
#include "tests/support/expect_error.h"

namespace gurney::statistics {
namespace {

/// Outcomes of Phi(2 ln a + ln_slope ln b) in `groups` of five runs whose scores share the normal
/// variable of their group with a variance of a half.
std::vector<VectorObservation> drawn(std::uint64_t seed, std::size_t groups, double ln_slope) {
  std::vector<VectorObservation> runs;
  for (std::size_t i = 0; i < 5 * groups; ++i) {
    const std::size_t group = i / 5;
    const auto normal = [&](std::uint64_t stream, std::uint64_t n) {
      return normal_quantile(uniform_draw(seed, stream, n));
    };
    VectorObservation run{std::exp(0.6 * normal(1, i)), std::exp(0.8 * normal(2, group)), false,
                          group};
    const double noise = std::sqrt(0.5) * (normal(3, i) + normal(4, group));
    run.exceeded = 2 * std::log(run.first) + ln_slope * std::log(run.second) > noise;
    runs.push_back(run);
  }
  return runs;
}

TEST(VectorFragility, AMeasureWithoutInfluenceAddsNothingAndMixingTurnsThePlane) {
  std::vector<Observation> alone;
  std::vector<VectorObservation> both = drawn(3, 200, 0);
  for (const VectorObservation& each : both)
    alone.push_back({each.first, each.exceeded, each.group});
  const FragilityFit scalar = fit_fragility(alone);
  const VectorFit fit = fit_vector(both);
  ASSERT_EQ(fit.status, VectorStatus::kFitted);
  // Twice the gain is chi-squared with one degree, a little more with groups: below 10.8 but once
  // in 1000.
  EXPECT_GE(fit.log_likelihood, scalar.log_likelihood);
  EXPECT_LT(2 * (fit.log_likelihood - scalar.log_likelihood), 10.8);
  for (VectorObservation& each : both) each.second = std::pow(each.first, 2) * each.second;
  const VectorFit mixed = fit_vector(both);
  EXPECT_NEAR(mixed.log_likelihood, fit.log_likelihood, 1e-8) << "the same plane, turned";
  EXPECT_NEAR(mixed.plane[0] + 2 * mixed.plane[1], fit.plane[0], 1e-7);
  EXPECT_NEAR(mixed.plane[1], fit.plane[1], 1e-7);
}

// ln a' = ln(c a) = ln a + ln c: the slopes stay, and the constant takes what they add. The planes are
// solutions of one convex problem in other coordinates; Newton's method ends below 1e-8.
TEST(VectorFragility, InOtherUnitsIsTheSameSurface) {
  std::vector<VectorObservation> runs = drawn(7, 100, 1);
  const VectorFit fit = fit_vector(runs);
  const double c = 9.81, d = 0.01;
  for (VectorObservation& each : runs) {
    each.first *= c;
    each.second *= d;
  }
  const VectorFit other = fit_vector(runs);
  EXPECT_NEAR(other.log_likelihood, fit.log_likelihood, 1e-8);
  EXPECT_NEAR(other.plane[0], fit.plane[0], 1e-7);
  EXPECT_NEAR(other.plane[1], fit.plane[1], 1e-7);
  EXPECT_NEAR(other.plane[2],
              fit.plane[2] - fit.plane[0] * std::log(c) - fit.plane[1] * std::log(d), 1e-7);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) {
      EXPECT_NEAR(other.covariance(i, j), fit.covariance(i, j), 1e-7);
      EXPECT_NEAR(other.cluster_covariance(i, j), fit.cluster_covariance(i, j), 1e-7);
    }
  EXPECT_NEAR(other.probability(c * 1.3, d * 0.8), fit.probability(1.3, 0.8), 1e-7);
}

TEST(VectorFragility, FindsKnownSlopes) {
  const VectorFit fit = fit_vector(drawn(1, 2000, 1));
  ASSERT_EQ(fit.status, VectorStatus::kFitted);
  EXPECT_EQ(fit.runs, 10000);
  EXPECT_EQ(fit.groups, 2000);
  // The noise has a variance of 1, so slopes are those of the score, within 4 standard errors.
  for (const auto& [slope, truth] : {std::pair{0, 2.0}, {1, 1.0}, {2, 0.0}})
    EXPECT_NEAR(fit.plane[slope], truth, 4 * std::sqrt(fit.cluster_covariance(slope, slope)));
  EXPECT_LT(std::sqrt(fit.cluster_covariance(1, 1)), 0.1);
  EXPECT_GT(fit.cluster_covariance(1, 1), 1.5 * fit.covariance(1, 1))
      << "b is of the group, as half of the noise: runs inform less than they seem to";
  EXPECT_NEAR(fit.share(), 2 / 3.0, 0.05);
  EXPECT_NEAR(fit.beta(), 1 / 3.0, 0.03);
  EXPECT_NEAR(fit.theta(), 1, 0.1);
  EXPECT_LT(fit.p_of(1), 1e-9);
  // The combination with its share is one measure with this curve.
  const double a = 0.7, b = 1.9, mixed = std::pow(a, fit.share()) * std::pow(b, 1 - fit.share());
  EXPECT_NEAR(fit.probability(a, b), normal_cdf(std::log(mixed / fit.theta()) / fit.beta()), 1e-12);
}

TEST(VectorFragility, AMeasureWithoutInfluenceIsCalledSoAtTheStatedRate) {
  // Of 400 records, for the covariance of groups holds for many (Liang & Zeger 1986).
  int by_groups = 0, by_runs = 0;
  const int repeats = 400;
  for (int i = 0; i < repeats; ++i) {
    const VectorFit fit = fit_vector(drawn(static_cast<std::uint64_t>(100 + i), 400, 0));
    by_groups += fit.p_of(1) < 0.05;
    by_runs += 2 * normal_cdf(-std::abs(fit.plane[1]) / std::sqrt(fit.covariance(1, 1))) < 0.05;
  }
  // Both tails of the binomial distribution at 0.25 %.
  EXPECT_GT(binomial_cdf(by_groups, repeats, 0.05), 0.0025) << by_groups;
  EXPECT_LT(binomial_cdf(by_groups - 1, repeats, 0.05), 0.9975) << by_groups;
  EXPECT_GT(binomial_cdf(by_runs - 1, repeats, 0.05), 0.9975)
      << by_runs << ": were runs independent, the test would show nothing of groups";
}

TEST(VectorFragility, SaysWhyThereIsNone) {
  EXPECT_EQ(fit_vector({}).status, VectorStatus::kNoRuns);
  EXPECT_EQ(fit_vector({{1, 1, true, 0}, {2, 1, true, 1}}).status, VectorStatus::kAllExceed);
  EXPECT_EQ(fit_vector({{1, 1, false, 0}}).status, VectorStatus::kNoneExceeds);
  std::vector<VectorObservation> runs = drawn(5, 30, 1);
  for (VectorObservation& each : runs) each.second = 3 * std::pow(each.first, 1.5);
  EXPECT_EQ(fit_vector(runs).status, VectorStatus::kTogether);
  // A line parts them though neither measure does by itself.
  runs = drawn(5, 30, 1);
  for (VectorObservation& each : runs) each.exceeded = each.first * each.second > 1;
  EXPECT_EQ(fit_vector(runs).status, VectorStatus::kSeparated);
  // One run on the line with either outcome: the plane may still turn without end.
  runs.push_back({1, 1, true, 0});
  runs.push_back({1, 1, false, 0});
  EXPECT_EQ(fit_vector(runs).status, VectorStatus::kSeparated);
  runs = drawn(5, 200, 1);
  for (VectorObservation& each : runs) each.exceeded = !each.exceeded;
  EXPECT_EQ(fit_vector(runs).status, VectorStatus::kNotIncreasing);
  for (const double bad : {0.0, -1.0, std::numeric_limits<double>::infinity(), std::nan("")})
    EXPECT_ERROR(fit_vector({{1, bad, true, 0}}), "must be > 0 and finite");
}

/// One capacity a record: ln capacity in a = 0.2 + m1 ln_ratio + 0.3 z, in brackets of this width.
std::vector<VectorCapacity> capacities(std::uint64_t seed, std::size_t records, double m1,
                                       double width) {
  std::vector<VectorCapacity> all;
  for (std::size_t i = 0; i < records; ++i) {
    const auto normal = [&](std::uint64_t stream) {
      return normal_quantile(uniform_draw(seed, stream, i));
    };
    const double ratio = 0.5 * normal(1), ln = 0.2 + m1 * ratio + 0.3 * normal(2);
    const double low = width > 0 ? width * std::floor(ln / width) : ln;
    all.push_back({{low, low + width, 1}, ratio, i});
  }
  return all;
}

// With brackets without width the fit is that of least squares, and p that of its Student's t.
TEST(VectorCapacities, ExactOnesAreALinearRegression) {
  const std::size_t n = 12;
  const auto all = capacities(1, n, -0.4, 0);
  double x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  for (const VectorCapacity& each : all) {
    x += each.ln_ratio / n;
    y += each.ln_first.low / n;
  }
  for (const VectorCapacity& each : all) {
    const double dx = each.ln_ratio - x, dy = each.ln_first.low - y;
    xx += dx * dx;
    xy += dx * dy;
    yy += dy * dy;
  }
  const double m1 = xy / xx, rest = yy - m1 * xy, sigma = std::sqrt(rest / n);
  const double error = std::sqrt(rest / (n - 2) / xx);
  const VectorFit fit = fit_vector_capacities(all, 1);
  ASSERT_EQ(fit.status, VectorStatus::kFitted);
  // Newton's method ends with a change below 1e-8.
  EXPECT_NEAR(fit.beta(), sigma, 1e-7);
  EXPECT_NEAR(fit.share(), 1 + m1, 1e-7);
  EXPECT_NEAR(std::log(fit.theta()), y - m1 * x, 1e-7);
  EXPECT_NEAR(fit.p_of(0), 2 * student_survival((1 + m1) / error, n - 2), 1e-7);
  EXPECT_NEAR(fit.p_of(1), 2 * student_survival(-m1 / error, n - 2), 1e-7);
  // A second measure that stays along a record has other slopes.
  const VectorFit stays = fit_vector_capacities(all, 0);
  EXPECT_NEAR(stays.plane[0], 1 / sigma, 1e-6);
  EXPECT_NEAR(stays.plane[1], fit.plane[1], 1e-6);
  EXPECT_NEAR(stays.p_of(1), fit.p_of(1), 1e-7);
}

// Brackets of an IDA tell what the runs of stripes tell of the same items.
TEST(VectorCapacities, AreThePlaneOfTheOutcomes) {
  std::vector<VectorObservation> runs;
  const auto all = capacities(2, 2000, -0.4, 0.1);
  for (std::size_t i = 0; i < all.size(); ++i)
    for (int level = 0; level < 5; ++level) {
      const double a =
          0.1 * (level - 3) + 0.4 * uniform_draw(9, static_cast<std::uint64_t>(level), i);
      runs.push_back({std::exp(a), std::exp(a + all[i].ln_ratio), a >= all[i].ln_first.high, i});
    }
  const VectorFit of_brackets = fit_vector_capacities(all, 1), of_runs = fit_vector(runs);
  ASSERT_EQ(of_brackets.status, VectorStatus::kFitted);
  EXPECT_EQ(of_brackets.exceeded, 2000);
  for (const auto& [slope, truth] : {std::pair{0, 2.0}, {1, 4 / 3.0}, {2, -2 / 3.0}})
    EXPECT_NEAR(of_brackets.plane[slope], truth,
                4 * std::sqrt(of_brackets.covariance(slope, slope)));
  // Exceedance above the upper end lowers the constant by half a bracket; slopes are the same.
  for (const Eigen::Index slope : {0, 1})
    EXPECT_NEAR(of_runs.plane[slope], of_brackets.plane[slope],
                4 * std::sqrt(of_runs.cluster_covariance(slope, slope)));
}

TEST(VectorCapacities, AMeasureWithoutInfluenceIsCalledSoAtTheStatedRate) {
  int called = 0;
  const int repeats = 1000;
  for (int i = 0; i < repeats; ++i)
    called += fit_vector_capacities(capacities(static_cast<std::uint64_t>(100 + i), 12, 0, 0.1), 1)
                  .p_of(1) < 0.05;
  // Both tails of the binomial distribution at 0.25 %.
  EXPECT_GT(binomial_cdf(called, repeats, 0.05), 0.0025) << called;
  EXPECT_LT(binomial_cdf(called - 1, repeats, 0.05), 0.9975) << called;
}

TEST(VectorCapacities, SayWhyThereIsNoPlane) {
  const double none = std::numeric_limits<double>::infinity();
  EXPECT_EQ(fit_vector_capacities({}, 1).status, VectorStatus::kNoRuns);
  EXPECT_EQ(fit_vector_capacities({{{1, none}, 0, 0}, {{2, none}, 1, 1}}, 1).status,
            VectorStatus::kNoneExceeds);
  EXPECT_EQ(fit_vector_capacities({{{-none, 1}, 0, 0}, {{-none, 2}, 1, 1}}, 1).status,
            VectorStatus::kAllExceed);
  auto all = capacities(3, 12, -0.4, 0.1);
  for (VectorCapacity& each : all) each.ln_ratio = 0.7;
  EXPECT_EQ(fit_vector_capacities(all, 1).status, VectorStatus::kTogether);
  all = capacities(3, 12, -0.4, 0.1);
  for (VectorCapacity& each : all) each.ln_first = {each.ln_ratio - 0.1, each.ln_ratio + 0.1};
  EXPECT_EQ(fit_vector_capacities(all, 1).status, VectorStatus::kInAllBrackets);
  EXPECT_EQ(fit_vector_capacities({all[0], all[1]}, 1).status, VectorStatus::kInAllBrackets);
  // A capacity in a that falls faster than b grows: stronger motions would be safer.
  EXPECT_EQ(fit_vector_capacities(capacities(4, 200, -2, 0.1), 0).status, VectorStatus::kFitted);
  EXPECT_EQ(fit_vector_capacities(capacities(4, 200, 2, 0.1), 0).status,
            VectorStatus::kNotIncreasing);
}

}  // namespace
}  // namespace gurney::statistics
