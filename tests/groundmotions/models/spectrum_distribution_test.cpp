#include "groundmotions/models/spectrum_distribution.h"

#include <gmock/gmock.h>

#include <cmath>

#include "tests/support/expect_error.h"

namespace gurney::groundmotions {
namespace {

const Scenario kScenario{7, 10, 400, Faulting::kStrikeSlip};
const Eigen::VectorXd kPeriods{{0.1, 0.3, 1, 2}};
constexpr Eigen::Index kAt = 2;  // T* = 1 s

TEST(SpectrumDistribution, IsThatOfItsScenario) {
  const SpectrumDistribution s = bssa14_spectrum(kScenario, kPeriods);
  for (Eigen::Index i = 0; i < kPeriods.size(); ++i) {
    const Prediction p = bssa14_sa(kScenario, kPeriods[i]);
    EXPECT_NEAR(s.mean[i], std::log(p.median), 1e-14);
    EXPECT_NEAR(s.sigma()[i], p.sigma(), 1e-14);
    // 1.959964: the standard normal quantile of 97.5 %, six decimals.
    EXPECT_NEAR(std::log(s.quantile(0.975)[i]), s.mean[i] + 1.959964 * p.sigma(), 1e-6);
  }
  EXPECT_NEAR(s.covariance(0, 3), epsilon_correlation(0.1, 2) * s.sigma()[0] * s.sigma()[3], 1e-14);
}

TEST(ConditionalSpectrum, IsExactAtItsPeriod) {
  const SpectrumDistribution all = bssa14_spectrum(kScenario, kPeriods);
  const SpectrumDistribution s = conditioned(all, kAt, 1.234);
  EXPECT_EQ(s.mean[kAt], 1.234);
  EXPECT_EQ(s.sigma()[kAt], 0);
  EXPECT_TRUE(s.covariance.row(kAt).isZero(0));
}

// Baker (2011), equation (5), by hand. Between 1 and 2 s, both beyond 0.109 s, the correlation is
// 1 - sin(0.366 ln 2) = 0.749021 (Baker & Jayaram 2008, equation (2)).
TEST(ConditionalSpectrum, HasTheMeanAndSigmaOfBaker) {
  const SpectrumDistribution all = bssa14_spectrum(kScenario, kPeriods);
  const double epsilon = 1.5, rho = 0.749021;
  const Prediction at_1 = bssa14_sa(kScenario, 1), at_2 = bssa14_sa(kScenario, 2);
  const SpectrumDistribution s =
      conditioned(all, kAt, std::log(at_1.median) + epsilon * at_1.sigma());
  // Six decimals of rho.
  EXPECT_NEAR(s.mean[3], std::log(at_2.median) + rho * epsilon * at_2.sigma(), 1e-6);
  EXPECT_NEAR(s.sigma()[3], at_2.sigma() * std::sqrt(1 - rho * rho), 1e-6);
  const double covariance = epsilon_correlation(0.1, 2) - rho * epsilon_correlation(0.1, 1);
  EXPECT_NEAR(s.covariance(0, 3), covariance * all.sigma()[0] * at_2.sigma(), 1e-6);
}

// A conditional spectrum that is given by its medians and sigmas has the same correlations.
TEST(CorrelatedSpectrum, HasTheCorrelationsThatTheConditionLeaves) {
  const SpectrumDistribution s = conditioned(bssa14_spectrum(kScenario, kPeriods), kAt, 1);
  const SpectrumDistribution same =
      correlated_spectrum(kPeriods, s.mean.array().exp(), s.sigma(), kAt);
  EXPECT_LT((same.covariance - s.covariance).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT((same.mean - s.mean).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(CorrelatedSpectrum, NeedsNoCorrelationsWithoutSigma) {
  const Eigen::VectorXd periods{{0.001, 20}}, median{{1, 2}};
  EXPECT_TRUE(correlated_spectrum(periods, median, Eigen::VectorXd::Zero(2)).covariance.isZero(0));
  EXPECT_ERROR(correlated_spectrum(periods, median, Eigen::VectorXd::Ones(2)),
               "correlations are for 0.01 to 10 s");
}

}  // namespace
}  // namespace gurney::groundmotions
