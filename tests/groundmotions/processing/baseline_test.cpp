#include "groundmotions/processing/baseline.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/base/random/normal_draw.h"
#include "groundmotions/measures/peaks.h"
#include "tests/support/error_text.h"

namespace gurney::groundmotions {
namespace {

constexpr double kStep = 0.005;
constexpr Eigen::Index kSamples = 4001;

Eigen::ArrayXd times() { return Eigen::ArrayXd::LinSpaced(kSamples, 0, 20); }

/// White noise, standard deviation 1 m/s2.
Eigen::VectorXd noise(std::uint64_t seed) {
  Eigen::VectorXd a(kSamples);
  for (Eigen::Index i = 0; i < kSamples; ++i)
    a[i] = normal_draw(seed, 0, static_cast<std::uint64_t>(i));
  return a;
}

// A least-squares fit of a polynomial of its own degree leaves rounding: the data below are at most
// 1 in size, a sum over 4001 samples has an error of 4001 eps = 1e-12.
TEST(Baseline, RemovesEveryPolynomialUpToItsDegree) {
  for (int degree = 0; degree <= 8; ++degree) {
    const Eigen::VectorXd a = (times() / 20).pow(degree) - 0.3;
    EXPECT_LT(without_polynomial(a, degree).cwiseAbs().maxCoeff(), 1e-12) << degree;
    // (t / T)^degree has the part 2 / 4^degree that no lower degree can fit (Chebyshev).
    if (degree == 0) continue;
    EXPECT_GT(without_polynomial(a, degree - 1).cwiseAbs().maxCoeff(), 1.99 / std::pow(4, degree))
        << degree;
  }
}

// The normal equations: what is left is orthogonal to every power up to the degree. Terms of size
// up to 4, 4001 of them, with an error of eps each in a sum of up to 1e4.
TEST(Baseline, LeavesNothingAlongItsPolynomials) {
  for (const int degree : {0, 1, 3, 8}) {
    const Eigen::VectorXd rest = without_polynomial(noise(1), degree);
    for (int k = 0; k <= degree; ++k)
      EXPECT_NEAR(rest.dot((times() / 20).pow(k).matrix()), 0, 1e-8) << degree << ' ' << k;
    EXPECT_LT((without_polynomial(rest, degree) - rest).cwiseAbs().maxCoeff(), 1e-12);
  }
}

// Slope and mean of the least-squares line in closed form.
TEST(Baseline, LineIsThatOfTheTextbook) {
  const Eigen::VectorXd a = noise(2);
  const Eigen::ArrayXd t = times() - 10;
  const double slope = (t * a.array()).sum() / t.square().sum();
  const Eigen::VectorXd wanted = a.array() - a.mean() - slope * t;
  EXPECT_LT((without_polynomial(a, 1) - wanted).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Baseline, PreEventMeanTakesOnlyTheStart) {
  Eigen::VectorXd a(6);
  a << 1, 2, 3, 10, 20, -30;
  Eigen::VectorXd wanted(6);
  wanted << -1, 0, 1, 8, 18, -32;
  EXPECT_EQ(without_pre_event_mean(0.1, a, 0.2), wanted);  // 0, 0.1 and 0.2 s
  EXPECT_EQ(without_pre_event_mean(0.1, a, 0.29), wanted);
  EXPECT_EQ(error_text([&] { without_pre_event_mean(0.1, a, 0.6); }),
            "the part before the event must be 0.1 to 0.5 s long (one step to the whole record), "
            "got 0.6 s");
  EXPECT_NE(error_text([&] { without_pre_event_mean(0.1, a, std::nan("")); }), "(no error)");
}

// Velocity and displacement are sums of n = 4001 terms; their rounding is at most n eps times the
// sum of the magnitudes: h sum |a| = 20 * 1.1 m/s for v and 20 s times that for d.
TEST(Baseline, EndsAtRestToRounding) {
  const Eigen::VectorXd a = noise(3).array() + 0.1 + 0.02 * times();
  ASSERT_GT(std::abs(end_motion(kStep, a).displacement), 10);
  const double rounding = kSamples * 2.3e-16 * 20 * 1.1;
  for (int degree = 1; degree <= 4; ++degree) {
    const EndMotion end = end_motion(kStep, ending_at_rest(a, degree));
    EXPECT_LT(std::abs(end.velocity), rounding) << degree;
    EXPECT_LT(std::abs(end.displacement), 20 * rounding) << degree;
  }
}

// p = alpha + beta t with alpha T + beta T^2 / 2 = V and alpha T^2 / 2 + beta T^3 / 6 = D.
TEST(Baseline, EndAtRestOfDegreeOneIsTheLineOfTheResiduals) {
  const Eigen::VectorXd a = noise(4);
  const EndMotion end = end_motion(kStep, a);
  const double v = end.velocity, d = end.displacement, t = 20;
  const Eigen::ArrayXd line =
      6 * d / (t * t) - 2 * v / t + (6 * v / (t * t) - 12 * d / (t * t * t)) * times();
  EXPECT_LT((ending_at_rest(a, 1) - (a.array() - line).matrix()).cwiseAbs().maxCoeff(), 1e-12);
}

// The fit: the displacement that is left is orthogonal to the displacement of every polynomial of
// that degree that ends at rest itself. Relative to the sizes of both: rounding of 4001 terms and
// of the double integrals, 1e-9.
TEST(Baseline, EndAtRestFitsTheDisplacement) {
  const Eigen::VectorXd a = noise(5).array() + 0.1;
  for (const int degree : {2, 3, 4}) {
    const Eigen::VectorXd left = integrated(kStep, ending_at_rest(a, degree)).displacement;
    for (int k = 2; k <= degree; ++k) {
      const Eigen::VectorXd p = ending_at_rest((times() / 20).pow(k), 1);
      const Eigen::VectorXd q = integrated(kStep, p).displacement;
      EXPECT_LT(std::abs(left.dot(q)), 1e-9 * left.norm() * q.norm()) << degree << ' ' << k;
    }
  }
}

TEST(Baseline, EndAtRestTwiceIsOnceAndIsLinear) {
  const Eigen::VectorXd a = noise(6), b = noise(7).array() + 1;
  for (const int degree : {1, 4}) {
    const Eigen::VectorXd ra = ending_at_rest(a, degree), rb = ending_at_rest(b, degree);
    EXPECT_LT((ending_at_rest(ra, degree) - ra).cwiseAbs().maxCoeff(), 1e-11);
    const Eigen::VectorXd both = ending_at_rest(2 * a - 3 * b, degree);
    EXPECT_LT((both - 2 * ra + 3 * rb).cwiseAbs().maxCoeff(), 1e-11);
  }
  // A record that ends at rest is kept as it is by the default, degree 1.
  const Eigen::VectorXd rest = ending_at_rest(a, 4);
  EXPECT_LT((ending_at_rest(rest) - rest).cwiseAbs().maxCoeff(), 1e-11);
}

TEST(Baseline, RefusesWhatCannotBe) {
  const Eigen::VectorXd four = Eigen::VectorXd::Ones(4);
  EXPECT_EQ(error_text([&] { without_polynomial(four, 9); }),
            "the degree of the polynomial must be 0 to 8, got 9");
  EXPECT_EQ(error_text([&] { without_polynomial(four, 3); }),
            "a polynomial of degree 3 needs at least 5 samples, got 4");
  EXPECT_EQ(error_text([&] { ending_at_rest(four, 0); }),
            "the degree of the polynomial must be 1 to 4, got 0");
  EXPECT_EQ(error_text([&] { ending_at_rest(four, 4); }),
            "a polynomial of degree 4 needs at least 6 samples, got 4");
}

}  // namespace
}  // namespace gurney::groundmotions
