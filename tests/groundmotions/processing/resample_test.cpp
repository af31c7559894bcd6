#include "groundmotions/processing/resample.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/error_text.h"

namespace gurney::groundmotions {
namespace {

constexpr double kPi = std::numbers::pi;

/// A wave packet: cosine of `frequency` [Hz] under a Gaussian around 10 s whose spectrum has a
/// standard deviation of 0.5 Hz: 3.5 Hz away from its frequency it is 2e-11 of its peak, and at 0
/// and 20 s it is zero to rounding.
Eigen::VectorXd packet(double frequency, double step, Eigen::Index samples) {
  const Eigen::ArrayXd t =
      Eigen::ArrayXd::LinSpaced(samples, 0, step * static_cast<double>(samples - 1)) - 10;
  return (2 * kPi * frequency * t + 0.7).cos() * (-(t * kPi).square() / 2).exp();
}

double error(double frequency, double old_step, double new_step) {
  const auto samples = static_cast<Eigen::Index>(std::round(20 / old_step)) + 1;
  const Eigen::VectorXd y = resampled(old_step, packet(frequency, old_step, samples), new_step);
  return (y - packet(frequency, new_step, y.size())).cwiseAbs().maxCoeff();
}

// Kaiser's window of 100 dB changes a sine within the pass band by 1e-5 and leaves 1e-5 of its
// first images; those farther off are smaller. Together less than 3e-5 of the peak, 1.
constexpr double kRipple = 3e-5;

TEST(Resample, KeepsTheBandAtFinerSteps) {
  // Nyquist frequency 50 Hz, kept up to 45 Hz; the packet is 3.5 Hz wide to each side.
  for (const double f : {1.0, 20.0, 41.5})
    for (const double step : {0.005, 0.002, 0.0075, 0.01 / kPi, 0.0099})
      EXPECT_LT(error(f, 0.01, step), kRipple) << f << " Hz, " << step << " s";
}

TEST(Resample, KeepsTheBandAtCoarserSteps) {
  // Kept up to 0.9 of the new Nyquist frequency, 22.5 Hz for 0.02 s.
  for (const double f : {1.0, 10.0, 19.0})
    for (const double step : {0.02, 0.015, 0.01 * kPi / 2, 0.011})
      EXPECT_LT(error(f, 0.01, step), kRipple) << f << " Hz, " << step << " s";
}

// A packet above the new Nyquist frequency, 25 Hz, is gone and not folded back.
TEST(Resample, LeavesNoAliases) {
  for (const double f : {28.5, 35.0, 45.0})
    EXPECT_LT(resampled(0.01, packet(f, 0.01, 2001), 0.02).cwiseAbs().maxCoeff(), kRipple) << f;
}

// The sinc has its zeros at all other samples, sin(pi k) apart: rounding, 66 terms.
TEST(Resample, KeepsOldSamples) {
  Eigen::VectorXd a = Eigen::VectorXd::LinSpaced(101, -1, 3);
  a[50] = 7;
  const Eigen::VectorXd y = resampled(0.01, a, 0.0025);
  ASSERT_EQ(y.size(), 401);
  for (Eigen::Index i = 0; i < a.size(); ++i) EXPECT_NEAR(y[4 * i], a[i], 1e-12);
  EXPECT_EQ(resampled(0.01, a, 0.01), a);
}

TEST(Resample, KeepsAConstantAwayFromTheEnds) {
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(1001);
  for (const double step : {0.003, 0.017, 0.04}) {
    const Eigen::VectorXd y = resampled(0.01, ones, step);
    const auto edge = static_cast<Eigen::Index>(std::ceil(std::max(0.33, 65 * step) / step));
    const auto inner = y.segment(edge, y.size() - 2 * edge - 1);
    ASSERT_GT(inner.size(), 10);
    EXPECT_LT((inner.array() - 1).abs().maxCoeff(), 1e-13) << step;
  }
}

TEST(Resample, EndsWithinTheRecord) {
  const auto samples = [](Eigen::Index old, double old_step, double new_step) {
    return resampled(old_step, Eigen::VectorXd::Zero(old), new_step).size();
  };
  EXPECT_EQ(samples(101, 0.01, 0.03), 34);  // 1 s: 0 to 0.99 s
  EXPECT_EQ(samples(100, 0.01, 0.03), 34);  // 0.99 s, reached by rounding
  EXPECT_EQ(samples(4001, 0.005, 0.02), 1001);
  EXPECT_EQ(samples(4004, 0.005, 0.02), 1001);
  EXPECT_EQ(samples(3, 0.01, 0.0033), 7);  // 0.02 s: 0 to 0.0198 s
  EXPECT_EQ(samples(2, 0.01, 0.01), 2);
}

TEST(Resample, IsLinearAndMovesWithTheMotion) {
  const Eigen::VectorXd a = packet(3, 0.01, 2001), b = packet(17, 0.01, 2001);
  const Eigen::VectorXd both = resampled(0.01, 2 * a - 3 * b, 0.004);
  EXPECT_LT(
      (both - 2 * resampled(0.01, a, 0.004) + 3 * resampled(0.01, b, 0.004)).cwiseAbs().maxCoeff(),
      1e-13);
  Eigen::VectorXd moved = Eigen::VectorXd::Zero(2021);  // 20 old steps are 50 new ones
  moved.tail(2001) = b;
  EXPECT_LT(
      (resampled(0.01, moved, 0.004).tail(5001) - resampled(0.01, b, 0.004)).cwiseAbs().maxCoeff(),
      1e-12);
}

TEST(Resample, RefusesWhatCannotBe) {
  const Eigen::VectorXd a = Eigen::VectorXd::Ones(101);
  EXPECT_EQ(error_text([&] { resampled(0.01, a, 0); }),
            "the new time step must be > 0 and give 2 to 1e+07 samples for 1 s, got 0 s");
  for (const double wrong : {-0.01, 1.01, 1e-9, std::nan("")})
    EXPECT_NE(error_text([&] { resampled(0.01, a, wrong); }), "(no error)") << wrong;
}

}  // namespace
}  // namespace gurney::groundmotions
