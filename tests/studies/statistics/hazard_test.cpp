#include "studies/statistics/hazard.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/expect_error.h"

namespace gurney::statistics {
namespace {

// Cornell's closed form.
TEST(MeanRate, OfAPowerLawIsTheClosedForm) {
  for (const double k : {0.5, 2.0, 3.5}) {
    const LognormalCurve curve{0.6, 0.45};
    const MeanRate mean = mean_rate(curve, HazardCurve::power_law(4e-4, k));
    const double expected = 4e-4 * std::pow(0.6, -k) * std::exp(k * k * 0.45 * 0.45 / 2);
    EXPECT_NEAR(mean.rate / expected, 1, 1e-12);
    EXPECT_TRUE(mean.complete());
  }
}

// A table on a power law from 1e-4 to 1e4 is the power law; the ends hold less than 1e-9 of it.
TEST(MeanRate, OfATableOnAPowerLawIsTheSame) {
  std::vector<double> im, rate;
  for (double x = 1e-4; x < 1.1e4; x *= 1.7) {
    im.push_back(x);
    rate.push_back(4e-4 * std::pow(x, -2.5));
  }
  const HazardCurve table = HazardCurve::table(im, rate);
  const LognormalCurve curve{0.6, 0.45};
  const double expected = mean_rate(curve, HazardCurve::power_law(4e-4, 2.5)).rate;
  EXPECT_NEAR(mean_rate(curve, table).rate / expected, 1, 1e-9);
  EXPECT_TRUE(mean_rate(curve, table).complete());
  // Three-point Gauss errs by the sixth derivative times 0.05^6 / 2e6 here.
  const auto probability = [&](double x) { return curve.probability(x); };
  EXPECT_NEAR(mean_rate(probability, table).rate / expected, 1, 1e-9);
}

// Pieces of different slopes; the closed form and Gauss-Legendre share nothing but the ends.
TEST(MeanRate, OfATableWithKinksIsTheNumericalIntegral) {
  const HazardCurve table =
      HazardCurve::table({0.05, 0.2, 0.5, 1, 2.5}, {0.2, 0.05, 0.01, 1e-3, 2e-5});
  const LognormalCurve curve{0.6, 0.45};
  const auto probability = [&](double im) { return curve.probability(im); };
  const MeanRate closed = mean_rate(curve, table), numerical = mean_rate(probability, table);
  EXPECT_NEAR(closed.rate / numerical.rate, 1, 1e-8);
  EXPECT_EQ(closed.most_above, numerical.most_above);
}

// A step at 0.5 is exceeded at the rate of 0.5; panels meet the step within 0.05 of ln im.
TEST(MeanRate, OfAStepIsTheHazardThere) {
  const HazardCurve table = HazardCurve::table({0.1, 0.5, 2}, {0.1, 0.01, 1e-4});
  EXPECT_NEAR(mean_rate(LognormalCurve{0.5, 1e-6}, table).rate, 0.01, 1e-7);
  const auto step = [](double im) { return im >= 0.5 ? 1.0 : 0.0; };
  EXPECT_NEAR(mean_rate(step, table).rate, 0.01, 1e-6);  // on a point, so met exactly
}

TEST(MeanRate, SaysWhatTheTableDoesNotReach) {
  const HazardCurve table = HazardCurve::table({0.2, 1}, {0.05, 0.002});
  const MeanRate mean = mean_rate(LognormalCurve{0.2, 0.5}, table);
  EXPECT_NEAR(mean.below, 0.5, 1e-12);
  EXPECT_FALSE(mean.complete());
  const LognormalCurve strong{2, 0.5};
  const MeanRate above = mean_rate(strong, table);
  EXPECT_NEAR(above.most_above, 0.002 * (1 - strong.probability(1)), 1e-15);
  EXPECT_FALSE(above.complete());
}

TEST(MeanRate, StaysFiniteOnSteepPieces) {
  const HazardCurve cliff = HazardCurve::table({1, 1.001, 2}, {1e-2, 1e-6, 1e-7});
  const double rate = mean_rate(LognormalCurve{1, 1}, cliff).rate;
  EXPECT_NEAR(rate, 0.5 * 1e-2, 1e-5);  // nearly all of the rate is at im = 1, where P = 1/2
}

TEST(Hazard, InterpolatesInLogarithmsAndDoesNotExtrapolate) {
  const HazardCurve table = HazardCurve::table({0.1, 1}, {1e-2, 1e-4});
  EXPECT_NEAR(*table.rate(std::sqrt(0.1)), 1e-3, 1e-15);
  EXPECT_NEAR(*table.rate(1), 1e-4, 1e-17);
  EXPECT_FALSE(table.rate(0.099));
  EXPECT_FALSE(table.rate(1.01));
  EXPECT_NEAR(*HazardCurve::power_law(1e-3, 2).rate(10), 1e-5, 1e-18);
  EXPECT_FALSE(HazardCurve::power_law(1e-3, 2).rate(0));
}

TEST(Hazard, RefusesWhatIsNone) {
  EXPECT_ERROR(HazardCurve::table({1}, {1}), "1 intensities have 1 rates: must be 2 or more");
  EXPECT_ERROR(HazardCurve::table({1, 1}, {2, 1}), "im[1] = 1 must be above 1");
  EXPECT_ERROR(HazardCurve::table({1, 2}, {1, 1}), "rate[1] = 1 must be below 1");
  EXPECT_ERROR(HazardCurve::table({1, 2}, {1, std::nan("")}), "rate[1] = nan must be > 0");
  EXPECT_ERROR(HazardCurve::power_law(0, 1), "k0 = 0 must be > 0");
  EXPECT_ERROR(mean_rate([](double) { return 1.0; }, HazardCurve::power_law(1, 1)),
               "needs a hazard table");
}

TEST(Hazard, TenPercentInFiftyYearsIsOnceIn475) {
  EXPECT_NEAR(probability_in(50, 1 / 474.561), 0.1, 1e-6);
  EXPECT_NEAR(probability_in(50, 1e-18), 5e-17, 1e-30);
}

// Parts add up to the whole, and each is that of a table cut there.
TEST(RateBetween, IsThePartOfTheIntegral) {
  const LognormalCurve curve{0.4, 0.6};
  const HazardCurve law = HazardCurve::power_law(1e-4, 2);
  const double below = rate_between(curve, law, 0, 0.2), middle = rate_between(curve, law, 0.2, 1),
               above = rate_between(curve, law, 1, INFINITY), whole = mean_rate(curve, law).rate;
  EXPECT_NEAR(below + middle + above, whole, 1e-12 * whole);
  const HazardCurve cut = HazardCurve::table({0.2, 1}, {*law.rate(0.2), *law.rate(1)});
  EXPECT_NEAR(middle, mean_rate(curve, cut).rate - curve.probability(1) * *law.rate(1),
              1e-12 * whole);
}

// Lines on an ellipse whose theta varies alone: the rate is theta^-k times a constant.
TEST(RateInterval, IsThatOfTheLinesOfTheBand) {
  const HazardCurve law = HazardCurve::power_law(1e-4, 2);
  const double slope = 2;
  const std::vector<Eigen::Vector2d> lines{{slope, -0.5}, {slope, 0.1}, {slope, 0.5}};
  const Interval interval = rate_interval(lines, law);
  EXPECT_NEAR(interval.low, mean_rate(LognormalCurve{std::exp(0.25), 0.5}, law).rate, 1e-15);
  EXPECT_NEAR(interval.high, mean_rate(LognormalCurve{std::exp(-0.25), 0.5}, law).rate, 1e-15);
  EXPECT_EQ(rate_interval({{-1, 0}}, law).high, INFINITY);
  // A table bounds it: P = 1/2 everywhere where the slope is 0.
  const HazardCurve table = HazardCurve::table({0.2, 1}, {1e-2, 1e-4});
  EXPECT_NEAR(rate_interval({{0, 0}}, table).high, 0.5e-2, 1e-9);
  EXPECT_EQ(rate_interval({}, table).high, INFINITY);
}

}  // namespace
}  // namespace gurney::statistics
