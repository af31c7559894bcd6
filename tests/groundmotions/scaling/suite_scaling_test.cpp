#include "groundmotions/scaling/suite_scaling.h"

#include <gmock/gmock.h>

#include <cmath>

#include "tests/support/expect_error.h"

namespace gurney::groundmotions {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

using Mean = SuiteScalingOptions::Mean;

Eigen::VectorXd periods() { return Eigen::VectorXd{{0.1, 0.2, 0.4, 0.8, 1.6}}; }
Eigen::VectorXd target() { return Eigen::VectorXd{{8, 8, 8, 4, 2}}; }
const std::vector<std::string> kNames = {"one", "two"};

TEST(ScaleSuite, FindsTheFactorOfScaledTargets) {
  Eigen::MatrixXd spectra(2, 5);
  spectra << target().transpose() / 2, target().transpose() * 3;
  const SuiteScaling s = scale_suite(periods(), spectra, target(), kNames, {.floor_share = 0});
  EXPECT_NEAR(s.factors[0], 2, 1e-12);
  EXPECT_NEAR(s.factors[1], 1 / 3., 1e-12);
  EXPECT_NEAR(s.common_factor, 1, 1e-12);
  EXPECT_NEAR(s.misfits.maxCoeff(), 0, 1e-7);
  EXPECT_NEAR(s.suite_misfit, 0, 1e-7);
  EXPECT_NEAR(s.smallest_ratio, 1, 1e-12);
  EXPECT_THAT(s.warnings, IsEmpty());
  const SuiteScaling lower = scale_suite(periods(), spectra, target(), kNames);
  EXPECT_NEAR(lower.factors[0], 1.8, 1e-12);  // 90 % of the target are enough
  EXPECT_NEAR(lower.smallest_ratio, 0.9, 1e-12);
}

// The closed form against a search: no other factor has a smaller misfit.
TEST(ScaleSuite, IsTheLeastSquares) {
  Eigen::MatrixXd spectra(1, 5);
  spectra << 3, 9, 7, 2, 1.5;
  const SuiteScaling s = scale_suite(periods(), spectra, target(), {"one"}, {.floor_share = 0});
  const auto misfit = [&](double factor) {
    // Periods are octaves apart: weights 1/8, 1/4, 1/4, 1/4, 1/8.
    const double w[] = {0.125, 0.25, 0.25, 0.25, 0.125};
    double sum = 0;
    for (int j = 0; j < 5; ++j)
      sum += w[j] * std::pow(std::log(factor * spectra(0, j) / target()[j]), 2);
    return std::sqrt(sum);
  };
  EXPECT_NEAR(s.misfits[0], misfit(s.factors[0]), 1e-12);
  EXPECT_LT(s.misfits[0], misfit(1.001 * s.factors[0]));
  EXPECT_LT(s.misfits[0], misfit(0.999 * s.factors[0]));
  EXPECT_NEAR(s.suite_misfit, s.misfits[0], 1e-12);  // a suite of one
}

TEST(ScaleSuite, DoesNotDependOnTheSpacingOfPeriods) {
  // ln(Sa / target) linear in ln T: the trapezoids are exact on any grid of the same range.
  const auto factor = [](const Eigen::VectorXd& t) {
    const Eigen::MatrixXd spectra = t.array().pow(0.7).matrix().transpose();
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(t.size());
    return scale_suite(t, spectra, ones, {"one"}, {.floor_share = 0}).factors[0];
  };
  const Eigen::VectorXd uneven{{0.1, 0.11, 0.12, 0.13, 1.6}};
  EXPECT_NEAR(factor(periods()), factor(uneven), 1e-12);
  EXPECT_NEAR(factor(periods()), std::pow(0.4, -0.7), 1e-12);  // sqrt(0.1 * 1.6) = 0.4
}

TEST(ScaleSuite, RaisesTheMeanToItsFloor) {
  Eigen::MatrixXd spectra(2, 5);
  spectra << 4, 8, 9, 4, 2,  //
      8, 6, 8, 5, 1;
  for (const Mean mean : {Mean::kArithmetic, Mean::kGeometric}) {
    const SuiteScaling s = scale_suite(periods(), spectra, target(), kNames, {.mean = mean});
    Eigen::VectorXd expected(5);
    for (int j = 0; j < 5; ++j) {
      const double a = s.factors[0] * spectra(0, j), b = s.factors[1] * spectra(1, j);
      expected[j] = mean == Mean::kArithmetic ? (a + b) / 2 : std::sqrt(a * b);
    }
    EXPECT_LT((s.mean - expected).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_NEAR((expected.array() / target().array()).minCoeff(), 0.9, 1e-12);
    EXPECT_NEAR(s.smallest_ratio, 0.9, 1e-12);
    EXPECT_EQ(s.period_of_smallest, mean == Mean::kArithmetic ? 1.6 : 0.1);
  }
}

TEST(ScaleSuite, KeepsLimitsAndSaysSo) {
  Eigen::MatrixXd spectra(2, 5);
  spectra << target().transpose() / 10, target().transpose();
  const SuiteScaling s = scale_suite(periods(), spectra, target(), kNames, {.floor_share = 0});
  EXPECT_NEAR(s.factors[0] / s.factors[1], 4, 1e-12);
  EXPECT_THAT(s.warnings, ElementsAre("one: the best factor is 10, held at the limit 4",
                                      HasSubstr("one: with the common factor the factor is 5.7")));
  EXPECT_EQ(s.own_factors[0], 4);
  const SuiteScaling common =
      scale_suite(periods(), spectra, target(), kNames, {.own_factors = false, .floor_share = 0});
  EXPECT_NEAR(common.factors[0], common.factors[1], 1e-12);
  // Arithmetic mean of 0.1 and 1 is 0.55 of the target.
  EXPECT_NEAR(common.factors[0], 1 / 0.55, 1e-12);
}

TEST(ScaleSuite, RefusesWhatDoesNotFit) {
  const Eigen::MatrixXd spectra = target().transpose();
  EXPECT_ERROR(scale_suite(periods(), spectra, target(), kNames), "1 records with 2 names");
  EXPECT_ERROR(scale_suite(periods().reverse(), spectra, target(), {"one"}),
               "at least two periods > 0 that grow");
  EXPECT_ERROR(scale_suite(periods(), 0 * spectra, target(), {"one"}),
               "one: its spectrum must be > 0 at all periods of the range");
  EXPECT_ERROR(scale_suite(periods(), spectra, -target(), {"one"}), "the target must be > 0");
  EXPECT_ERROR(scale_suite(periods(), spectra, target(), {"one"},
                           {.smallest_factor = 2, .largest_factor = 1}),
               "limits of factors 2 to 1: must be >= 0 and grow");
}

}  // namespace
}  // namespace gurney::groundmotions
