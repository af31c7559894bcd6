#include "studies/statistics/fragility.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "studies/statistics/special.h"
#include "tests/studies/statistics/synthetic.h"
#include "tests/support/expect_error.h"

namespace gurney::statistics {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Baker's likelihood written down once more, in theta and beta.
double log_likelihood(const std::vector<Stripe>& stripes, double theta, double beta) {
  double sum = 0;
  for (const Stripe& stripe : stripes) {
    const double p = 0.5 * std::erfc(-std::log(stripe.im / theta) / beta / std::sqrt(2.0));
    if (stripe.exceeded > 0) sum += stripe.exceeded * std::log(p);
    if (stripe.runs > stripe.exceeded) sum += (stripe.runs - stripe.exceeded) * std::log(1 - p);
  }
  return sum;
}

const std::vector<Stripe> kStripes{{0.2, 40, 0},  {0.4, 40, 2},  {0.6, 40, 7}, {0.8, 40, 9},
                                   {1.0, 40, 17}, {1.2, 40, 22}, {1.6, 40, 30}};

std::vector<Observation> of_stripes(const std::vector<Stripe>& stripes) {
  std::vector<Observation> all;
  for (const Stripe& stripe : stripes)
    for (int run = 0; run < stripe.runs; ++run)
      all.push_back({stripe.im, run < stripe.exceeded, all.size()});
  return all;
}

TEST(Fragility, CountsInAnyOrder) {
  std::vector<Observation> seen{{2, true, 7}, {1, false, 7}, {2, false, 3}, {1, false, 3}};
  const StripeTable table(seen);
  ASSERT_EQ(table.stripes().size(), 2u);
  EXPECT_EQ(table.groups(), 2u);
  EXPECT_EQ(table.stripes()[1].im, 2);
  EXPECT_EQ(table.stripes()[1].fraction(), 0.5);
  EXPECT_EQ(table.resampled({0, 3})[1].exceeded, 3);  // group 7 comes second
  EXPECT_EQ(table.resampled({0, 3})[0].runs, 3);
  EXPECT_ERROR(StripeTable({{0, true, 0}}), "im = 0 must be > 0");
  EXPECT_ERROR(StripeTable({{std::nan(""), true, 0}}), "im = nan must be > 0");
}

// Counts that lie on a curve exactly give it back, whatever the levels: the score is zero there.
TEST(Fragility, ReturnsTheCurveOfExactFractions) {
  for (const LognormalCurve curve : {LognormalCurve{0.5, 0.4}, {2, 0.05}, {1e-3, 1.5}}) {
    std::vector<Stripe> stripes;
    for (const double score : {-2.5, -1.0, 0.2, 0.9, 3.0})
      stripes.push_back({curve.theta * std::exp(curve.beta * score), 50, 50 * normal_cdf(score)});
    const ProbitFit fit = fit_probit(stripes);
    ASSERT_EQ(fit.status, FragilityStatus::kFitted);
    EXPECT_NEAR(1 / fit.line[0], curve.beta, 1e-9 * curve.beta);
    EXPECT_NEAR(std::exp(-fit.line[1] / fit.line[0]), curve.theta, 1e-9 * curve.theta);
  }
}

// A search on ever finer grids knows nothing of derivatives. The likelihood is flat to rounding
// (1e-16 of 1e2) within the root of that, 1e-7, of its maximum.
TEST(Fragility, AgreesWithASearchOnAGrid) {
  double theta = 1, beta = 0.5, span = 0.45;
  for (int round = 0; round < 40; ++round, span *= 0.6) {
    double best = -kInfinity, best_theta = theta, best_beta = beta;
    for (int i = -4; i <= 4; ++i) {
      for (int j = -4; j <= 4; ++j) {
        const double t = theta * (1 + span * i / 4), b = beta * (1 + span * j / 4);
        const double value = log_likelihood(kStripes, t, b);
        if (value > best) best = value, best_theta = t, best_beta = b;
      }
    }
    theta = best_theta, beta = best_beta;
  }
  const FragilityFit fit = fit_fragility(of_stripes(kStripes));
  ASSERT_TRUE(fit.curve);
  EXPECT_NEAR(fit.curve->theta, theta, 1e-6);
  EXPECT_NEAR(fit.curve->beta, beta, 1e-6);
  EXPECT_NEAR(fit.log_likelihood, log_likelihood(kStripes, theta, beta), 1e-10);
  EXPECT_EQ(fit.runs, 280u);
  EXPECT_EQ(fit.exceeded, 87u);
  EXPECT_EQ(fit.groups, 280u);
}

TEST(Fragility, CovarianceIsTheInverseCurvatureInLnThetaAndLnBeta) {
  const FragilityFit fit = fit_fragility(of_stripes(kStripes));
  const double h = 1e-3;
  const auto at = [&](double i, double j) {
    return log_likelihood(kStripes, fit.curve->theta * std::exp(i * h),
                          fit.curve->beta * std::exp(j * h));
  };
  Eigen::Matrix2d curvature;
  curvature(0, 0) = -(at(1, 0) - 2 * at(0, 0) + at(-1, 0)) / (h * h);
  curvature(1, 1) = -(at(0, 1) - 2 * at(0, 0) + at(0, -1)) / (h * h);
  curvature(0, 1) = curvature(1, 0) =
      -(at(1, 1) - at(1, -1) - at(-1, 1) + at(-1, -1)) / (4 * h * h);
  // The differences err by h^2 / 12 of a fourth derivative of the size of the second.
  EXPECT_TRUE(curvature.inverse().isApprox(fit.covariance, 1e-5)) << fit.covariance;
}

// Each run k times in its group: the clusters have k times the runs but know no more.
TEST(Fragility, ClusterCovarianceIsNotFooledByRepeatedRuns) {
  const std::vector<Observation> once = of_stripes(kStripes);
  std::vector<Observation> thrice = once;
  for (int i = 0; i < 2; ++i) thrice.insert(thrice.end(), once.begin(), once.end());
  const FragilityFit a = fit_fragility(once), b = fit_fragility(thrice);
  EXPECT_NEAR(a.curve->theta, b.curve->theta, 1e-9);
  EXPECT_TRUE(b.cluster_covariance.isApprox(a.cluster_covariance, 1e-8));
  EXPECT_TRUE((3 * b.covariance).isApprox(a.covariance, 1e-8));
}

// With one run in each group both estimate the same; the spread of a variance from n runs is of the
// size sqrt(2 / n), 0.02 for 3600.
TEST(Fragility, ClusterCovarianceIsTheUsualOneForIndependentRuns) {
  SyntheticStudy study{.records = 400};
  std::vector<Observation> seen = study.outcomes(3);
  for (std::size_t i = 0; i < seen.size(); ++i) seen[i].group = i;
  const FragilityFit fit = fit_fragility(seen);
  for (int i : {0, 1}) EXPECT_NEAR(fit.cluster_covariance(i, i) / fit.covariance(i, i), 1, 0.15);
}

TEST(Fragility, OrderOfRunsChangesNoBit) {
  std::vector<Observation> seen = SyntheticStudy{}.outcomes(1);
  const FragilityFit forward = fit_fragility(seen);
  std::reverse(seen.begin(), seen.end());
  const FragilityFit backward = fit_fragility(seen);
  EXPECT_EQ(forward.curve->theta, backward.curve->theta);
  EXPECT_EQ(forward.cluster_covariance, backward.cluster_covariance);
}

struct Degenerate {
  std::vector<Stripe> stripes;
  FragilityStatus status;
  double low, high;
};

TEST(Fragility, SaysWhyThereIsNoCurve) {
  using enum FragilityStatus;
  const std::vector<Degenerate> cases{
      {{}, kNoRuns, 0, 0},
      {{{1, 5, 5}, {2, 5, 5}}, kAllExceed, 0, 1},
      {{{1, 5, 0}, {2, 5, 0}}, kNoneExceeds, 2, kInfinity},
      {{{1, 5, 0}, {2, 5, 0}, {3, 5, 5}}, kSeparated, 2, 3},
      {{{1, 5, 0}, {2, 5, 2}, {3, 5, 5}}, kQuasiSeparated, 2, 2},
      {{{2, 5, 2}}, kQuasiSeparated, 2, 2},
      {{{1, 5, 5}, {2, 5, 0}}, kNotIncreasing, 0, kInfinity},
      {{{1, 5, 4}, {2, 5, 1}}, kNotIncreasing, 0, 0},
      {{{1, 4, 2}, {2, 4, 2}}, kNotIncreasing, 0, 0},
  };
  for (const Degenerate& c : cases) {
    const FragilityFit fit = fit_fragility(of_stripes(c.stripes));
    EXPECT_EQ(fit.status, c.status) << text(c.status);
    EXPECT_FALSE(fit.curve) << text(c.status);
    EXPECT_TRUE(fit.covariance.isZero()) << text(c.status);
    EXPECT_EQ(fit.low, c.low) << text(c.status);
    EXPECT_EQ(fit.high, c.high) << text(c.status);
    EXPECT_TRUE(std::isfinite(fit.log_likelihood)) << text(c.status);
  }
  EXPECT_NE(text(kSeparated).find("beta cannot be estimated"), std::string::npos);
}

// Of 2 in 5: 2 ln 0.4 + 3 ln 0.6, which no finite beta reaches.
TEST(Fragility, LikelihoodOfQuasiSeparatedRunsIsItsLimit) {
  EXPECT_NEAR(fit_probit({{1, 5, 0}, {2, 5, 2}, {3, 5, 5}}).log_likelihood,
              2 * std::log(0.4) + 3 * std::log(0.6), 1e-14);
  // One level decides where the probability falls, too; a step down fits without a loss.
  EXPECT_NEAR(fit_probit({{1, 5, 5}, {2, 5, 2}, {3, 5, 0}}).log_likelihood,
              2 * std::log(0.4) + 3 * std::log(0.6), 1e-14);
  EXPECT_EQ(fit_probit({{1, 5, 5}, {2, 5, 0}}).log_likelihood, 0);
}

// Nearly separated: one run out of place among many, so beta is tiny against the range of im.
TEST(Fragility, FitsASteepCurve) {
  std::vector<Stripe> stripes{
      {1e-3, 1000, 0}, {0.99, 1000, 1}, {1.01, 1000, 999}, {1e3, 1000, 1000}};
  const ProbitFit fit = fit_probit(stripes);
  ASSERT_EQ(fit.status, FragilityStatus::kFitted);
  // By hand: both middle stripes are met exactly, ln 1.01 - ln 0.99 = 2 * 3.0902323 beta.
  EXPECT_NEAR(1 / fit.line[0], std::log(1.01 / 0.99) / (2 * 3.0902323061678132), 1e-9);
}

}  // namespace
}  // namespace gurney::statistics
