#include "studies/statistics/sensitivity.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "engine/base/random/normal_draw.h"
#include "engine/base/random/sampling.h"
#include "tests/support/expect_error.h"

namespace gurney::statistics {
namespace {

/// Ishigami & Homma (1990) with a = 7, b = 0.1, from u in (0, 1); its indices are closed forms.
double ishigami(double u1, double u2, double u3) {
  const auto x = [](double u) { return std::numbers::pi * (2 * u - 1); };
  return std::sin(x(u1)) + 7 * std::pow(std::sin(x(u2)), 2) +
         0.1 * std::pow(x(u3), 4) * std::sin(x(u1));
}
const double kPi4 = std::pow(std::numbers::pi, 4), kPi8 = kPi4 * kPi4;
const double kVariance = 49 / 8.0 + 0.1 * kPi4 / 5 + 0.01 * kPi8 / 18 + 0.5;
const double kFirst[3]{0.5 * std::pow(1 + 0.1 * kPi4 / 5, 2) / kVariance, 49 / 8.0 / kVariance, 0};
const double kBoth = 0.01 * kPi8 * 8 / 225 / kVariance;  // x1 and x3 together
const double kTotal[3]{kFirst[0] + kBoth, kFirst[1], kBoth};

TEST(VarianceIndex, LiesFrom0To1InItsInterval) {
  const auto within = [](double estimate, double low, double high) {
    const VarianceIndex index = VarianceIndex::within_0_and_1(estimate, {low, high});
    return std::array{index.estimate, index.interval.low, index.interval.high};
  };
  EXPECT_EQ(within(0.3, -0.1, 1.2), (std::array{0.3, 0.0, 1.0}));
  EXPECT_EQ(within(1.05, 0.8, 1.3), (std::array{1.0, 0.8, 1.0}));
  EXPECT_EQ(within(-0.02, -0.1, 0.1), (std::array{0.0, 0.0, 0.1}));
}

TEST(SobolIndices, OfIshigamiAreTheClosedForms) {
  EXPECT_NEAR(kFirst[0] + kFirst[1] + kBoth, 1, 1e-12);
  const std::uint64_t n = 8192;
  std::vector<double> a, b;
  std::vector<std::vector<double>> ab(3);
  for (std::uint64_t i = 0; i < n; ++i) {
    double u[6];
    for (std::uint64_t d = 0; d < 6; ++d) u[d] = sobol_draw(1, d, i);
    a.push_back(ishigami(u[0], u[1], u[2]));
    b.push_back(ishigami(u[3], u[4], u[5]));
    ab[0].push_back(ishigami(u[3], u[1], u[2]));
    ab[1].push_back(ishigami(u[0], u[4], u[2]));
    ab[2].push_back(ishigami(u[0], u[1], u[5]));
  }
  const auto indices = sobol_indices(a, b, ab, {.resamples = 99});
  ASSERT_EQ(indices.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    // Random points err by about 1 / sqrt(n) = 0.011, Sobol points by much less.
    EXPECT_NEAR(indices[i].first.estimate, kFirst[i], 0.01) << i;
    EXPECT_NEAR(indices[i].total.estimate, kTotal[i], 0.01) << i;
    EXPECT_TRUE(indices[i].total.interval.contains(kTotal[i])) << i;
  }
  EXPECT_TRUE(sobol_indices({1, 1}, {1, 1}, {{1, 1}}).empty());
  EXPECT_ERROR(sobol_indices({1, 2}, {1, 2}, {{1}}), "AB[0] has 1 runs: must be 2");
}

// 2000 runs: the estimate's standard deviation is about sqrt(4 S (1 - S) / n), 0.02, and
// 45 classes of an input leave (range of x / 45)^2 of the curvature out.
TEST(FirstOrderIndex, OfIshigamiFromPlainRuns) {
  std::vector<std::vector<double>> u(3);
  std::vector<double> y;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    for (std::uint64_t d = 0; d < 3; ++d) u[d].push_back(uniform_draw(1, d, i));
    y.push_back(ishigami(u[0][i], u[1][i], u[2][i]));
  }
  for (std::size_t d = 0; d < 3; ++d) {
    const auto index = first_order_index(u[d], y);
    ASSERT_TRUE(index);
    EXPECT_NEAR(index->estimate, kFirst[d], 0.06) << d;
    EXPECT_TRUE(index->interval.contains(kFirst[d]))
        << d << ' ' << index->interval.low << ' ' << index->interval.high;
  }
}

// y = x1 + x2 + noise of variances 4, 1, 5: S = 0.4. No bias for many classes of few runs, and what
// is left of the mean of 300 repeats is 4.5 standard errors.
TEST(FirstOrderIndex, HasNoBiasFromManyClassesAndItsIntervalCovers) {
  int covered = 0;
  double sum = 0, squares = 0, noise_sum = 0;
  for (std::uint64_t repeat = 0; repeat < 300; ++repeat) {
    std::vector<double> x, unrelated, y;
    for (std::uint64_t i = 0; i < 200; ++i) {
      x.push_back(2 * normal_draw(repeat, 0, i));
      unrelated.push_back(normal_draw(repeat, 1, i));
      y.push_back(x.back() + normal_draw(repeat, 2, i) +
                  std::sqrt(5.0) * normal_draw(repeat, 3, i));
    }
    const auto index = first_order_index(x, y, {.bins = 20, .resamples = 199, .seed = repeat});
    sum += index->estimate;
    squares += index->estimate * index->estimate;
    covered += index->interval.contains(0.4);
    noise_sum += first_order_index(unrelated, y, {.bins = 20, .resamples = 0})->estimate;
  }
  const double mean = sum / 300, error = std::sqrt((squares / 300 - mean * mean) / 300);
  // Classes of normal x lose the variance within them, 1.7 % of it for 20.
  EXPECT_NEAR(mean, 0.4 * (1 - 0.017), 4.5 * error + 0.004);
  EXPECT_NEAR(noise_sum / 300, 0, 4.5 * error);
  EXPECT_GT(covered, 300 * 0.88);
  RecordProperty("covered", covered);
}

TEST(FirstOrderIndex, TakesTheRecordAsAClass) {
  std::vector<std::size_t> record;
  std::vector<double> y;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    record.push_back(i % 20 + 1000);
    y.push_back(normal_draw(1, 0, i % 20) + 0.5 * normal_draw(1, 1, i));
  }
  // The 20 records are all there are: their variance is that of the 20 numbers drawn.
  double mean = 0, squares = 0;
  for (std::uint64_t r = 0; r < 20; ++r) mean += normal_draw(1, 0, r) / 20;
  for (std::uint64_t r = 0; r < 20; ++r) squares += std::pow(normal_draw(1, 0, r) - mean, 2) / 20;
  EXPECT_NEAR(first_order_index_of_classes(record, y)->estimate, squares / (squares + 0.25), 0.02);
}

TEST(FirstOrderIndex, IsNoneWithoutVarianceOrRuns) {
  EXPECT_FALSE(first_order_index({1, 2, 3, 4}, {5, 5, 5, 5}));
  EXPECT_FALSE(first_order_index({1, 2, 3}, {1, 2, 3}, {.bins = 3}));
  EXPECT_FALSE(first_order_index({}, {}));
  EXPECT_NEAR(first_order_index({1, 1, 2, 2}, {0, 0, 1, 1})->estimate, 1, 1e-15);
  EXPECT_ERROR(first_order_index({1}, {}), "1 inputs have 0 outputs");
}

// y = 3 u1 - u2: means of the lowest and highest tenth of u are 0.05 and 0.95.
TEST(Tornado, RanksInputsByTheirSwing) {
  std::vector<std::vector<double>> u(3);
  std::vector<double> y;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    for (std::uint64_t d = 0; d < 3; ++d) u[d].push_back(latin_hypercube_draw(1, d, i, 1000));
    y.push_back(3 * u[1][i] - u[2][i]);
  }
  const auto bars = tornado(u, y);
  ASSERT_EQ(bars.size(), 3u);
  EXPECT_EQ(bars[0].input, 1u);
  EXPECT_EQ(bars[1].input, 2u);
  EXPECT_NEAR(bars[0].low, 0.15 - 0.5, 4.5 * bars[0].low_error);
  EXPECT_NEAR(bars[0].swing(), 2.7, 4.5 * std::hypot(bars[0].low_error, bars[0].high_error));
  EXPECT_NEAR(bars[1].swing(), -0.9, 4.5 * std::hypot(bars[1].low_error, bars[1].high_error));
  // The lowest and highest two of 10: means 1.5 and 9.5, variances 1 / 2, standard errors sqrt(0.5 / 2).
  const TornadoBar bar =
      tornado({{1, 2, 3, 4, 5, 6, 7, 8, 9, 10}}, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10}, 0.2)[0];
  EXPECT_EQ(bar.low_runs, 2u);
  EXPECT_NEAR(bar.low_error, std::sqrt(0.5 / 2), 1e-12);
  EXPECT_NEAR(bar.high_error, std::sqrt(0.5 / 2), 1e-12);
  EXPECT_ERROR(tornado(u, y, 0.6), "share = 0.6 must be in (0, 0.5]");
  EXPECT_ERROR(tornado({{1.0}}, {1.0}), "a share 0.1 of 1 runs is less than 2");
}

}  // namespace
}  // namespace gurney::statistics
