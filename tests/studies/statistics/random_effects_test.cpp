#include "studies/statistics/random_effects.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/base/random/normal_draw.h"
#include "studies/statistics/special.h"
#include "tests/support/expect_error.h"

namespace gurney::statistics {
namespace {

const Eigen::MatrixXd kMean6 = Eigen::MatrixXd::Ones(6, 1);

// Equal errors: the interval of the mean by Student's t, whatever their share of the scatter, but
// no less than the errors alone make.
TEST(RandomEffects, IsStudentsIntervalForEqualErrors) {
  Eigen::VectorXd y(6);
  y << 1.2, 0.8, 1.1, 0.9, 1.3, 0.7;  // mean 1, sum of squares 0.28
  for (const double error : {0.0, 0.05, 0.2, 5.0}) {
    const auto fit = fit_random_effects(y, Eigen::VectorXd::Constant(6, error), kMean6);
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->coefficients[0], 1, 1e-12);
    EXPECT_NEAR(fit->error(0), std::sqrt(std::max(0.28 / 5, error * error) / 6), 1e-6);
    EXPECT_NEAR(fit->scatter, std::sqrt(std::max(0.0, 0.28 / 5 - error * error)), 1e-6);
    EXPECT_NEAR(fit->interval(0).high, 1 + student_quantile(0.975, 5) * fit->error(0), 1e-12);
    EXPECT_NEAR(fit->p_value(0, 1), 1, 1e-9);
  }
}

// Paule & Mandel's equation holds at the scatter that is found.
TEST(RandomEffects, MakesTheWeightedSquaresTheirDegrees) {
  Eigen::VectorXd y(6), error(6);
  y << 1.2, 0.8, 1.1, 0.9, 1.6, 0.4;
  error << 0.01, 0.3, 0.1, 0.2, 0.05, 0.15;
  const auto fit = fit_random_effects(y, error, kMean6);
  ASSERT_TRUE(fit);
  const Eigen::ArrayXd variance = error.array().square() + fit->scatter * fit->scatter;
  EXPECT_NEAR(((y.array() - fit->coefficients[0]).square() / variance).sum(), 5, 1e-9);
  EXPECT_NEAR(fit->coefficients[0], (y.array() / variance).sum() / (1 / variance).sum(), 1e-12);
}

TEST(RandomEffects, RefusesWhatCannotBeFitted) {
  const Eigen::VectorXd y = Eigen::VectorXd::Ones(6), none = Eigen::VectorXd::Zero(6);
  EXPECT_FALSE(fit_random_effects(y, none, Eigen::MatrixXd::Ones(6, 2)));
  EXPECT_FALSE(fit_random_effects(y, none, Eigen::MatrixXd::Identity(6, 6)));
  EXPECT_TRUE(fit_random_effects(y, none, kMean6));  // no scatter at all
  EXPECT_ERROR(fit_random_effects(y, -y, kMean6), "errors of measurement must be >= 0");
}

// 1000 repeats of 12 units with unequal errors and a covariate without influence. Acceptance: 95 %
// +- 3.3 standard deviations of the binomial distribution, 0.927 to 0.973.
TEST(RandomEffects, CoversAsStated) {
  int covered = 0, covered_slope = 0, found = 0, outliers = 0;
  constexpr int kRepeats = 1000, kUnits = 12;
  for (int repeat = 0; repeat < kRepeats; ++repeat) {
    Eigen::VectorXd y(kUnits), error(kUnits);
    Eigen::MatrixXd design(kUnits, 3);
    for (int i = 0; i < kUnits; ++i) {
      const auto draw = [&](std::uint64_t stream) {
        return normal_draw(static_cast<std::uint64_t>(repeat), stream, static_cast<unsigned>(i));
      };
      error[i] = 0.01 * (1 + i % 4);
      design.row(i) << 1, i - 5.5, i % 3;
      y[i] = 2 + 0.03 * draw(0) + error[i] * draw(1);
    }
    const auto fit = fit_random_effects(y, error, design);
    covered += fit->interval(0).contains(2);
    covered_slope += fit->interval(1).contains(0);
    found += fit->p_value(2) < 0.05;
    for (const double p : outlier_p_values(y, error, design)) outliers += p < 0.05;
  }
  EXPECT_NEAR(covered, 950, 23);
  EXPECT_NEAR(covered_slope, 950, 23);
  EXPECT_NEAR(found, 50, 23);
  // Bonferroni: at most 5 % of the repeats name somebody.
  EXPECT_LT(outliers, 50 + 23);
  EXPECT_GT(outliers, 10);
}

TEST(RandomEffects, NamesTheUnitThatIsOff) {
  Eigen::VectorXd y(6);
  y << 1.02, 0.98, 1.01, 0.99, 1.03, 2;
  const auto p = outlier_p_values(y, Eigen::VectorXd::Constant(6, 0.01), kMean6);
  EXPECT_LT(p[5], 1e-4);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(p[static_cast<std::size_t>(i)], 1);
}

}  // namespace
}  // namespace gurney::statistics
