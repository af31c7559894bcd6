
#include <gtest/gtest.h>

#include <cmath>

#include "groundmotions/measures/combination.h"
#include "groundmotions/measures/response_spectrum.h"
#include "groundmotions/scaling/suite_scaling.h"

namespace gurney::groundmotions {
namespace {

// A notch in the shape of a V of depth 2 % at ln T = 0.013, between periods ln T = 0.05 apart: the
// spacing sees 1 - 0.02 (1 - 0.013 / 0.06) at best.
TEST(LowestRatio, FindsANotchBetweenPeriods) {
  const auto ratios_at = [](const Eigen::VectorXd& periods) -> Eigen::VectorXd {
    return periods.unaryExpr([](double period) {
      return 1 - 0.02 * std::max(0.0, 1 - std::abs(std::log(period) - 0.013) / 0.06);
    });
  };
  const Eigen::VectorXd periods = Eigen::ArrayXd::LinSpaced(41, -1, 1).exp();
  const Eigen::VectorXd ratios = ratios_at(periods);
  EXPECT_GT(ratios.minCoeff(), 0.984);
  const LowestRatio lowest = lowest_ratio(periods, ratios, ratios_at, 1e-4);
  EXPECT_NEAR(lowest.ratio, 0.98, 0.98e-4);
  // 1e-4 of the ratio on a slope of 0.02 / 0.06.
  EXPECT_NEAR(std::log(lowest.period), 0.013, 0.98e-4 / (0.02 / 0.06));
}

/// Three motions of decaying sines, whose spectra are jagged.
Record motion(double seed) {
  Component component;
  component.time_step = 0.01;
  component.acceleration = Eigen::VectorXd::Zero(2000);
  for (Eigen::Index i = 0; i < 2000; ++i) {
    const double t = 0.01 * static_cast<double>(i);
    for (int k = 1; k < 25; ++k)
      component.acceleration[i] +=
          std::exp(-t / 6) * std::sin(k * (0.9 + 0.13 * seed) * t + seed * k * k);
  }
  Record record;
  record.components[0] = component;
  return record;
}

// The rule on a grid 40 times as fine as that of the fit.
TEST(ScaleSuite, KeepsTheFloorBetweenPeriods) {
  const std::vector<Record> records = {motion(1), motion(2.3), motion(4.1)};
  const auto spectra_at = [&](const Eigen::VectorXd& periods) {
    Eigen::MatrixXd spectra(3, periods.size());
    for (Eigen::Index i = 0; i < 3; ++i)
      spectra.row(i) =
          combined_spectrum(Combination::kH1, records[static_cast<std::size_t>(i)], periods, 0.05)
              .transpose();
    return spectra;
  };
  const auto target = [](double period) { return period < 0.4 ? 8 : 3.2 / period; };
  const Eigen::VectorXd periods = logarithmic_periods(0.1, 2, 100),
                        fine = logarithmic_periods(0.1, 2, 4001);
  const Eigen::MatrixXd at_fine = spectra_at(fine);
  const auto lowest_of = [&](const SuiteScaling& scaling) {
    const Eigen::VectorXd mean =
        (scaling.factors.asDiagonal() * at_fine).colwise().mean().transpose();
    return (mean.array() / fine.unaryExpr(target).array()).minCoeff();
  };
  const std::vector<std::string> names = {"a", "b", "c"};
  const SuiteScaling coarse =
      scale_suite(periods, spectra_at(periods), periods.unaryExpr(target), names);
  EXPECT_LT(lowest_of(coarse), 0.9 * (1 - 1e-4));
  for (const bool own : {true, false}) {
    SuiteScalingOptions options;
    options.own_factors = own;
    const SuiteScaling scaling = scale_suite(periods, {spectra_at, target}, names, options);
    EXPECT_GE(lowest_of(scaling), 0.9);
    EXPECT_LE(lowest_of(scaling), 0.9 * (1 + 3e-4));  // the tolerance, and the fine grid's own
    EXPECT_NEAR(scaling.smallest_ratio, 0.9, 0.9 * 2e-4);
  }
}

}  // namespace
}  // namespace gurney::groundmotions
