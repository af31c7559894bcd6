#include "engine/base/random/distribution.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/base/random/draw.h"
#include "tests/support/error_text.h"

namespace gurney {
namespace {

constexpr double kInfinity = Distribution::kInfinity;

std::vector<Distribution> one_of_each() {
  return {Distribution::normal(5, 2),
          Distribution::normal(5, 2, 4, 10),
          Distribution::normal(0, 1, 3, 4),
          Distribution::normal(0, 1, -kInfinity, -2),
          Distribution::lognormal(30, 0.1),
          Distribution::lognormal(30, 0.5, 27, 45),
          Distribution::lognormal(2, 0.8, 0, 3),
          Distribution::uniform(-1, 3),
          Distribution::discrete({3, 1, 2}, {0.2, 0.5, 0.3}),
          Distribution::samples({4, 1, 1, 2}),
          Distribution::table({0, 1, 4}, {0, 0.75, 1})};
}

// Closed forms: quantiles of the standard normal from Abramowitz & Stegun (1964), table 26.5.
TEST(Distribution, HasTheQuantilesOfClosedForms) {
  EXPECT_NEAR(Distribution::normal(10, 2).quantile(0.975), 10 + 2 * 1.959963984540054, 1e-14);
  EXPECT_NEAR(Distribution::lognormal(30, 0.1).quantile(0.05),
              30 * std::exp(-0.1 * 1.6448536269514722), 1e-13);
  EXPECT_DOUBLE_EQ(Distribution::uniform(-1, 3).quantile(0.25), 0);
  // Truncated at its mean, the normal is the half-normal: Phi^-1((1 + p) / 2).
  EXPECT_NEAR(Distribution::normal(0, 1, 0).quantile(0.95), 1.959963984540054, 1e-14);
  // Half of the far tail: Q(x) = Q(4) / 2, with Q(x) = erfc(x / sqrt 2) / 2; a relative error e of
  // x is one of x^2 e in Q, about 19 here, for each of five roundings.
  const double x = Distribution::normal(0, 1, 4).quantile(0.5);
  EXPECT_NEAR(2 * std::erfc(x / std::sqrt(2)) / std::erfc(4 / std::sqrt(2)), 1, 100 * 1.2e-16);
  const Distribution discrete = Distribution::discrete({3, 1, 2}, {0.2, 0.5, 0.3});
  EXPECT_EQ(discrete.quantile(0.4999), 1);
  EXPECT_EQ(discrete.quantile(0.5001), 2);
  EXPECT_EQ(discrete.quantile(0.9), 3);
  const Distribution table = Distribution::table({0, 1, 4}, {0, 0.75, 1});
  EXPECT_DOUBLE_EQ(table.quantile(0.375), 0.5);
  EXPECT_DOUBLE_EQ(table.quantile(0.875), 2.5);
}

// Rounding of p by e moves x by e / density; the sums behind lose a few e (16 here), and the
// density is at least 1e-3 of the mean one at these p.
TEST(Distribution, CdfInvertsQuantile) {
  for (const Distribution& law : one_of_each()) {
    for (const double p : {1e-6, 0.01, 0.3, 0.5, 0.9, 0.999}) {
      const double x = law.quantile(p);
      EXPECT_TRUE(law.contains(x)) << law.text() << " " << p;
      if (law.values().empty()) {
        EXPECT_NEAR(law.cdf(x), p, 16 * 2.3e-16) << law.text() << " " << p;
      } else {
        EXPECT_GE(law.cdf(x), p) << law.text();
        EXPECT_LT(law.cdf(std::nextafter(x, -kInfinity)), p) << law.text();
      }
    }
    EXPECT_EQ(law.cdf(std::nextafter(law.low(), -kInfinity)), 0) << law.text();
    EXPECT_EQ(law.cdf(law.high()), 1) << law.text();
  }
}

// mean = integral of the quantile function over p, and so for the square. The midpoint rule with n
// cells is exact to half a cell times the rise of q between the ends of its cells: the two ends
// hold all of it, q(p) grows there like a normal score, < 6 sd for 1 / (2 n). 4 cells are ample for
// the mean, 36 for squares.
TEST(Distribution, MomentsAreThoseOfTheQuantileFunction) {
  constexpr int kCells = 200000;
  for (const Distribution& law : one_of_each()) {
    double sum = 0, squares = 0;
    for (int i = 0; i < kCells; ++i) {
      const double x = law.quantile((i + 0.5) / kCells) - law.mean();
      sum += x / kCells;
      squares += x * x / kCells;
    }
    EXPECT_NEAR(sum / law.sd(), 0, 4.0 / kCells) << law.text();
    EXPECT_NEAR(squares / (law.sd() * law.sd()), 1, 36.0 / kCells) << law.text();
  }
}

// The mean of n draws scatters by sd / sqrt n, their variance by sqrt((kurtosis - 1) / n) relative;
// the kurtosis of the laws above is below 12 (the lognormals are truncated or narrow). 4.5 standard
// deviations: one false alarm in 1.5e5 for each of 22 numbers.
TEST(Distribution, DrawsHaveItsMoments) {
  constexpr int kDraws = 100000;
  for (const Distribution& law : one_of_each()) {
    double sum = 0, squares = 0;
    for (int run = 0; run < kDraws; ++run) {
      const Draw draw(11, static_cast<std::uint64_t>(run));
      const double x = law.quantile(draw.probability(law.text())) - law.mean();
      sum += x;
      squares += x * x;
    }
    const double scatter = 4.5 / std::sqrt(kDraws);
    EXPECT_NEAR(sum / kDraws / law.sd(), 0, scatter) << law.text();
    EXPECT_NEAR(squares / kDraws / (law.sd() * law.sd()), 1, std::sqrt(11) * scatter) << law.text();
  }
}

// Share of draws below the p-quantile: binomial, sqrt(p (1 - p) / n); 4.5 of it.
TEST(Distribution, DrawsFallBelowAQuantileAsOftenAsItSays) {
  constexpr int kDraws = 100000;
  for (const Distribution& law : one_of_each()) {
    if (!law.values().empty()) continue;
    for (const double p : {0.05, 0.5, 0.95}) {
      int below = 0;
      for (int run = 0; run < kDraws; ++run)
        below += law.quantile(Draw(3, static_cast<std::uint64_t>(run)).probability("x")) <=
                 law.quantile(p);
      EXPECT_NEAR(below / double{kDraws}, p, 4.5 * std::sqrt(p * (1 - p) / kDraws)) << law.text();
    }
  }
}

TEST(Distribution, HasClosedFormMoments) {
  const Distribution lognormal = Distribution::lognormal(2, 0.4);
  EXPECT_DOUBLE_EQ(lognormal.mean(), 2 * std::exp(0.08));
  EXPECT_DOUBLE_EQ(lognormal.sd(), 2 * std::exp(0.08) * std::sqrt(std::expm1(0.16)));
  const Distribution half = Distribution::normal(0, 3, 0);
  EXPECT_DOUBLE_EQ(half.mean(), 3 * std::sqrt(2 / std::numbers::pi));
  EXPECT_DOUBLE_EQ(half.sd(), 3 * std::sqrt(1 - 2 / std::numbers::pi));
  EXPECT_DOUBLE_EQ(Distribution::uniform(1, 7).sd(), 6 / std::sqrt(12));
  EXPECT_DOUBLE_EQ(Distribution::samples({1, 1, 4}).mean(), 2);
  EXPECT_DOUBLE_EQ(Distribution::samples({1, 1, 4}).sd(), std::sqrt(2));
}

TEST(Distribution, SaysWhatItIs) {
  EXPECT_EQ(Distribution::normal(5, 2).text(), "normal, mean 5, sd 2");
  EXPECT_EQ(Distribution::normal(5, 2, 4, 10).text(), "normal, mean 5, sd 2, within 4 to 10");
  EXPECT_EQ(Distribution::lognormal(30, 0.1).text(), "lognormal, median 30, beta 0.1");
  EXPECT_EQ(Distribution::lognormal(30, 0.1, 27).text(),
            "lognormal, median 30, beta 0.1, at least 27");
  EXPECT_EQ(Distribution::normal(5, 2, -kInfinity, 9).text(), "normal, mean 5, sd 2, at most 9");
  EXPECT_EQ(Distribution::uniform(0, 360).text(), "uniform, 0 to 360");
  EXPECT_EQ(Distribution::discrete({1, 0}, {0.7, 0.3}).text(), "discrete, 0 (0.3), 1 (0.7)");
  EXPECT_EQ(Distribution::samples({4, 1, 1}).text(), "3 samples, 1 to 4");
  EXPECT_EQ(Distribution::table({0, 1, 4}, {0, 0.75, 1}).text(), "table of 3 points, 0 to 4");
}

TEST(Distribution, RefusesWhatIsNone) {
  using D = Distribution;
  const auto wrong = [](auto make) { return error_text([&] { make(); }); };
  EXPECT_EQ(wrong([] { D::normal(1, 0); }), "sd = 0 must be > 0");
  EXPECT_EQ(wrong([] { D::normal(1, NAN); }), "sd = nan must be > 0");
  EXPECT_EQ(wrong([] { D::normal(1, 1, 3, 3); }), "low = 3 must be below high = 3");
  EXPECT_EQ(wrong([] { D::normal(0, 1, 6, 7); }),
            "low and high leave 9.9e-10 of the distribution (normal, mean 0, sd 1, within 6 to 7): "
            "must leave at least 1e-06");
  EXPECT_EQ(wrong([] { D::lognormal(0, 1); }), "median = 0 must be > 0");
  EXPECT_EQ(wrong([] { D::lognormal(1, -1); }), "beta = -1 must be > 0");
  EXPECT_EQ(wrong([] { D::lognormal(1, 1, -1); }), "low = -1 must be >= 0");
  EXPECT_EQ(wrong([] { D::uniform(2, 1); }), "low = 2 must be below high = 1");
  EXPECT_EQ(wrong([] {
              D::discrete({1, 2}, {1});
            }),
            "2 values have 1 probabilities: must be one for each");
  EXPECT_EQ(wrong([] { D::discrete({1, 2}, {1, 0}); }), "probabilities[1] = 0 must be > 0");
  EXPECT_EQ(wrong([] {
              D::discrete({1, 2}, {0.5, 0.4});
            }),
            "the probabilities sum to 0.9: must be 1");
  EXPECT_EQ(wrong([] { D::discrete({1, 1}, {0.5, 0.5}); }), "the value 1 comes twice");
  EXPECT_EQ(wrong([] { D::samples({}); }), "there are no samples");
  EXPECT_EQ(wrong([] { D::table({1}, {1}); }),
            "1 values have 1 cumulative probabilities: must be 2 or more of each");
  EXPECT_EQ(wrong([] { D::table({1, 1}, {0, 1}); }), "the values must increase");
  EXPECT_EQ(wrong([] {
              D::table({1, 2}, {0, 0.9});
            }),
            "the cumulative probabilities must increase from 0 to 1");
}

}  // namespace
}  // namespace gurney
