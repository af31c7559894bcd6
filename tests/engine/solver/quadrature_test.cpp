#include "engine/solver/quadrature.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gurney {
namespace {

constexpr double kFrom = 0.3, kTo = 0.37, kStep = kTo - kFrom;

TEST(StageMeans, AreTheValuesOfALinearFunctionAtTheStageTimes) {
  const auto integral = [](double t) { return 2 * t + 1.5 * t * t; };
  const StageMeans means = stage_means(kFrom, kTo - kFrom, integral);
  EXPECT_NEAR(means.first, 2 + 3 * (kFrom + kSdirkGamma * kStep), 1e-13);
  EXPECT_NEAR(means.second, 2 + 3 * kTo, 1e-13);
}

TEST(StageMeans, WeighToTheExactMeanOfAnyFunction) {
  for (const auto& integral : {+[](double t) { return std::sin(40 * t); },
                               +[](double t) { return t < 0.33 ? 0.0 : 7 * (t - 0.33); },
                               +[](double t) { return std::exp(9 * t); }}) {
    const StageMeans means = stage_means(kFrom, kTo - kFrom, integral);
    const double mean = (integral(kTo) - integral(kFrom)) / kStep;
    EXPECT_NEAR((1 - kSdirkGamma) * means.first + kSdirkGamma * means.second, mean,
                1e-13 * (1 + std::abs(mean)));
  }
}

TEST(StageMeans, TheMethodIsOfSecondOrderAndLStable) {
  const double g = kSdirkGamma;
  EXPECT_NEAR(2 * g - g * g, 0.5, 1e-15);  // sum b_i c_i = (1 - g) g + g = 1/2
  // R(z) = (1 + (1 - 2 g) z) / (1 - g z)^2 tends to 0.
  EXPECT_NEAR((1 + (1 - 2 * g) * -1e9) / std::pow(1 + g * 1e9, 2), 0, 1e-8);
}

}  // namespace
}  // namespace gurney
