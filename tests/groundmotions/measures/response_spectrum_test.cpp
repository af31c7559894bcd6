#include "groundmotions/measures/response_spectrum.h"

#include <gmock/gmock.h>

#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "tests/support/error_text.h"

namespace gurney::groundmotions {
namespace {

using Eigen::VectorXd;
constexpr double kPi = std::numbers::pi;

VectorXd one(double period) { return VectorXd::Constant(1, period); }

/// Invented, with all frequencies that its samples can hold.
VectorXd rough_motion(int samples) {
  VectorXd a(samples);
  for (int i = 0; i < samples; ++i)
    a[i] = 3 * std::sin(0.9 * i) * std::exp(-0.01 * i) + 2 * std::sin(0.07 * i * i) +
           std::cos(2.5 * i);
  return a;
}

// A step of acceleration p at 0 s: u = -p / w^2 (1 - exp(-z w t) (...)), whose peak at half a
// damped period is p / w^2 (1 + exp(-pi z / sqrt(1 - z^2))). The time step divides that half
// period.
TEST(ResponseSpectrum, AnswersAStepWithTheKnownOvershoot) {
  const double z = 0.05, period = 0.8, damped = period / std::sqrt(1 - z * z), dt = damped / 40;
  const auto s = response_spectrum(dt, VectorXd::Constant(200, 3.0), one(period), z);
  const double overshoot = 1 + std::exp(-kPi * z / std::sqrt(1 - z * z));
  EXPECT_NEAR(s.pseudo_acceleration[0], 3 * overshoot, 1e-13);
  EXPECT_DOUBLE_EQ(s.displacement[0], s.pseudo_acceleration[0] * std::pow(period / (2 * kPi), 2));
  EXPECT_DOUBLE_EQ(s.pseudo_velocity[0], s.displacement[0] * 2 * kPi / period);
}

// After a half sine pulse of duration d < T / 2, an undamped oscillator swings freely with
// u w^2 / p = 4 (T / d) cos(pi d / T) / ((T / d)^2 - 4)  (Chopra, Dynamics of Structures, 4.7).
// Between samples the pulse is linear: its area and shape are off by less than (pi dt / d)^2 / 12
// = 8e-7 of p; the grid of T/200 misses at most 1.3e-4.
TEST(ResponseSpectrum, LooksIntoTheFreeVibrationAfterTheRecord) {
  const double d = 0.2, period = 1.0, ratio = period / d;
  const int samples = 1001;
  VectorXd a(samples);
  for (int i = 0; i < samples; ++i) a[i] = std::sin(kPi * i / (samples - 1));
  const double exact = 4 * ratio * std::cos(kPi / ratio) / (ratio * ratio - 4);
  const auto between =
      response_spectrum(d / (samples - 1), a, one(period), 0, PeakAt::kBetweenSamples);
  EXPECT_NEAR(between.pseudo_acceleration[0], exact, 1.4e-4 * exact);
  EXPECT_LE(between.pseudo_acceleration[0], exact * (1 + 1e-6));
  // At the samples the record ends before the peak.
  const auto at_samples = response_spectrum(d / (samples - 1), a, one(period), 0);
  EXPECT_LT(at_samples.pseudo_acceleration[0], 0.9 * exact);
}

// Harmonic at resonance: the steady amplitude of w^2 u is p / (2 z). Samples are 1/200 of a period
// apart: (pi / 100)^2 / 12 = 8e-5 is lost to the straight lines, 1.3e-4 to the samples, and after
// 40 cycles exp(-40 * 2 pi z) = 3.5e-6 of the transient is left.
TEST(ResponseSpectrum, ReachesTheSteadyAmplitudeAtResonance) {
  const double period = 0.5, dt = period / 200;
  VectorXd a(8001);
  for (int i = 0; i < a.size(); ++i) a[i] = std::sin(2 * kPi * i * dt / period);
  const auto s = response_spectrum(dt, a, one(period), 0.05);
  EXPECT_NEAR(s.pseudo_acceleration[0], 10, 10 * 2.2e-4);
  // |2 z w v + w^2 u| has the amplitude sqrt(1 + 4 z^2) / (2 z).
  EXPECT_NEAR(s.absolute_acceleration[0], 10 * std::sqrt(1.01), 10 * 2.2e-4);
}

// An independent solution: the two complex modes of the oscillator, q' = lambda q - a, each driven
// by a straight line; u = Im(q) / w_d.
TEST(ResponseSpectrum, AgreesWithComplexModes) {
  const double dt = 0.01, z = 0.05;
  const VectorXd a = rough_motion(3000);
  const VectorXd periods = logarithmic_periods(0.005, 20, 61);
  const auto s = response_spectrum(dt, a, periods, z);
  for (int k = 0; k < periods.size(); ++k) {
    using Complex = std::complex<long double>;
    const long double w = 2 * std::numbers::pi_v<long double> / periods[k];
    const long double wd = w * std::sqrt(1 - static_cast<long double>(z) * z);
    const Complex lambda(-z * w, wd), decay = std::exp(lambda * static_cast<long double>(dt));
    Complex q = 0;
    long double largest = 0, largest_absolute = 0;
    for (int i = 1; i < a.size(); ++i) {
      const long double slope = (static_cast<long double>(a[i]) - a[i - 1]) / dt;
      // The particular solution of q' = lambda q - (a + slope t).
      const auto line = [&](long double t) {
        return (a[i - 1] + slope * t) / lambda + slope / (lambda * lambda);
      };
      q = decay * (q - line(0)) + line(dt);
      const long double u = q.imag() / wd, v = (lambda * q).imag() / wd;
      largest = std::max(largest, std::abs(u));
      largest_absolute = std::max(largest_absolute, std::abs(2 * z * w * v + w * w * u));
    }
    // 3000 steps that each add a rounding error of 2e-16 to a response of some cycles' memory.
    EXPECT_NEAR(s.displacement[k] / static_cast<double>(largest), 1, 1e-12) << periods[k];
    EXPECT_NEAR(s.absolute_acceleration[k] / static_cast<double>(largest_absolute), 1, 1e-12)
        << periods[k];
  }
}

// On the same straight lines cut into 40 parts, peaks at samples are peaks between samples.
TEST(ResponseSpectrum, FindsPeaksBetweenSamples) {
  const VectorXd a = rough_motion(400);
  const VectorXd periods = logarithmic_periods(0.05, 2, 20);
  VectorXd fine(399 * 40 + 1);
  for (int i = 0; i < fine.size(); ++i) {
    const int k = std::min(i / 40, 398);
    fine[i] = a[k] + (a[k + 1] - a[k]) * (i - 40 * k) / 40.0;
  }
  const auto coarse = response_spectrum(0.01, a, periods);
  const auto between = response_spectrum(0.01, a, periods, 0.05, PeakAt::kBetweenSamples);
  const auto reference = response_spectrum(0.01 / 40, fine, periods);
  double worst = 0;
  for (int k = 0; k < periods.size(); ++k) {
    EXPECT_GE(between.pseudo_acceleration[k], coarse.pseudo_acceleration[k] * (1 - 1e-12));
    // The free vibration could only add.
    const double missed = 1.3e-4 * (reference.pseudo_acceleration[k] + a.cwiseAbs().maxCoeff());
    EXPECT_GE(between.pseudo_acceleration[k], reference.pseudo_acceleration[k] - missed);
    worst = std::max(worst, 1 - coarse.pseudo_acceleration[k] / between.pseudo_acceleration[k]);
  }
  EXPECT_GT(worst, 0.02);  // there was something to find
}

TEST(ResponseSpectrum, OfPeriodZeroIsThePeakOfTheMotion) {
  const VectorXd a = rough_motion(500);
  VectorXd periods(4);
  periods << 1.0, 0.0, 1e-7, 1e-4;
  for (const auto at : {PeakAt::kSamples, PeakAt::kBetweenSamples}) {
    const auto s = response_spectrum(0.01, a, periods, 0.05, at);
    const double pga = a.cwiseAbs().maxCoeff();
    EXPECT_EQ(s.pseudo_acceleration[1], pga);
    EXPECT_EQ(s.absolute_acceleration[1], pga);
    EXPECT_EQ(s.displacement[1], 0);
    // A jump of slope rings with |slope change| / omega: at most 4 pga / (2 pi dt / T).
    EXPECT_NEAR(s.pseudo_acceleration[2], pga, pga * 4e-5);
    EXPECT_NEAR(s.pseudo_acceleration[3], pga, pga * 0.01);
  }
}

TEST(ResponseSpectrum, TakesPeriodsInAnyOrder) {
  const VectorXd a = rough_motion(300);
  const VectorXd up = logarithmic_periods(0.1, 5, 21), down = up.reverse();
  const auto s = response_spectrum(0.01, a, up), t = response_spectrum(0.01, a, down);
  EXPECT_EQ(s.displacement, t.displacement.reverse());
  EXPECT_EQ(t.period, down);
  for (int k = 0; k < up.size(); ++k)  // and alone
    EXPECT_EQ(response_spectrum(0.01, a, one(up[k])).displacement[0], s.displacement[k]);
}

TEST(ResponseSpectrum, IsStableForEveryPeriod) {
  const VectorXd a = rough_motion(2000);
  const auto s = response_spectrum(0.02, a, logarithmic_periods(1e-9, 1e6, 50), 0);
  EXPECT_TRUE(s.displacement.allFinite());
  // Very long periods: the mass stays in place, so SD is the largest ground displacement.
  double v = 0, d = 0, largest = 0;
  for (int i = 1; i < a.size(); ++i) {
    d += 0.02 * v + 0.02 * 0.02 / 6 * (2 * a[i - 1] + a[i]);
    v += 0.01 * (a[i - 1] + a[i]);
    largest = std::max(largest, std::abs(d));
  }
  EXPECT_NEAR(s.displacement[49], largest, 1e-6 * largest);
}

TEST(ResponseSpectrum, RefusesWhatIsOutOfRange) {
  const VectorXd a = rough_motion(10);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(error_text([&] { response_spectrum(0.01, a, one(-1)); }),
            "period -1 s is out of range: at least 0");
  EXPECT_EQ(error_text([&] { response_spectrum(0.01, a, one(nan)); }),
            "period nan s is out of range: at least 0");
  EXPECT_EQ(error_text([&] { response_spectrum(0.01, a, one(1), 1); }),
            "damping 1 is out of range: at least 0 and below 1");
}

TEST(ResponseSpectrum, OfNothingIsZero) {
  const auto s = response_spectrum(0.01, VectorXd(), logarithmic_periods(0.1, 1, 3));
  EXPECT_EQ(s.pseudo_acceleration, VectorXd::Zero(3));
}

TEST(ResponseSpectrum, WarnsOfPeriodsBelowTenSteps) {
  EXPECT_THAT(short_period_warning(0.02, 0.1),
              testing::HasSubstr("Sa(0.1 s): the time step of 0.02 s gives fewer than 10 samples"));
  EXPECT_EQ(short_period_warning(0.01, 0.1), "");
  EXPECT_EQ(short_period_warning(0.01, 0), "");
}

}  // namespace
}  // namespace gurney::groundmotions
