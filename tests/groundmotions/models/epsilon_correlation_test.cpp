#include <gmock/gmock.h>

#include "engine/base/linear_algebra.h"
#include "groundmotions/measures/response_spectrum.h"
#include "groundmotions/models/bssa14.h"
#include "tests/support/expect_error.h"

namespace gurney::groundmotions {
namespace {

TEST(EpsilonCorrelation, IsOneAtOnePeriodAndSymmetric) {
  for (const double period : {0.01, 0.1, 0.15, 1., 10.})
    EXPECT_NEAR(epsilon_correlation(period, period), 1, 1e-12);
  EXPECT_EQ(epsilon_correlation(0.05, 2), epsilon_correlation(2, 0.05));
  // Both beyond 0.109 s, equation (2) alone: 1 - cos(pi/2 - 0.366 ln 2) = 1 - sin(0.2537).
  EXPECT_NEAR(epsilon_correlation(1, 2), 1 - std::sin(0.366 * std::log(2.)), 1e-12);
}

// Baker & Jayaram (2008), both below 0.109 s: 1 - 0.105 (1 - 1 / (1 + e^(100 T - 5))) (T - t) / (T - 0.0099), by hand
// with t = 0.05 and 0.01 s and T = 0.1 s.
TEST(EpsilonCorrelation, OfShortPeriodsIsThatOfItsRange) {
  EXPECT_NEAR(epsilon_correlation(0.05, 0.1), 0.942121, 1e-6);
  EXPECT_NEAR(epsilon_correlation(0.01, 0.1), 1 - 0.105 * 0.993307 * 0.09 / 0.0901, 1e-6);
}

// A correlation matrix has no negative eigenvalue. The formula is a fit with four decimals, so that one of
// size n may have one of about -1e-4 n.
TEST(EpsilonCorrelation, IsACorrelation) {
  const Eigen::VectorXd periods = logarithmic_periods(0.05, 5, 24);
  Eigen::MatrixXd matrix(24, 24);
  for (Eigen::Index i = 0; i < 24; ++i)
    for (Eigen::Index j = 0; j < 24; ++j)
      matrix(i, j) = epsilon_correlation(periods[i], periods[j]);
  EXPECT_GT(eigenvalues(matrix).real().minCoeff(), -24e-4);
}

// The constants of the ranges have two digits: they meet to 0.005.
TEST(PgvCorrelation, ItsRangesMeet) {
  for (const double end : {0.1, 0.75, 2.5})
    EXPECT_NEAR(pgv_correlation(end), pgv_correlation(end * (1 + 1e-9)), 0.005);
  // The velocity goes with the period of about 1 s; the shortest period is PGA, 0.733 in the same paper.
  EXPECT_NEAR(pgv_correlation(0.01), 0.733, 0.005);
  EXPECT_GT(pgv_correlation(1), pgv_correlation(0.1));
}

TEST(Correlations, RefusePeriodsOutOfRange) {
  EXPECT_ERROR(epsilon_correlation(0.001, 1), "correlations are for 0.01 to 10 s");
  EXPECT_ERROR(pgv_correlation(11), "correlations are for 0.01 to 10 s");
}

}  // namespace
}  // namespace gurney::groundmotions
