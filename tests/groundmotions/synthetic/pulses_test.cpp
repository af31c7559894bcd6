#include "groundmotions/synthetic/pulses.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "groundmotions/measures/peaks.h"
#include "groundmotions/synthetic/component.h"
#include "tests/support/expect_error.h"

namespace gurney::groundmotions {
namespace {

using std::numbers::pi;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double kStep = 0.005;

const Component& h1(const Record& record) { return *record[Direction::kH1]; }
Peaks peaks_of(const Record& record) { return peaks(kStep, h1(record).acceleration); }
Eigen::Vector2d end_of(const Record& record) { return end_state(kStep, h1(record).acceleration); }

// A sine of period T is integrated with a relative error of (omega dt)^2 / 12, T = 1 s: 8e-5; its
// crest is a sample here. The correction of the end state is of the same order.
constexpr double kIntegration = 2e-4;

TEST(Pulses, HalfSineHasItsPeaksAndLeavesAVelocity) {
  const Record record = half_sine(kStep, 3, 1);
  EXPECT_NEAR(peaks_of(record).acceleration, 3, 3 * 1e-12);
  EXPECT_NEAR(end_of(record)[0], 3 / pi, 3 / pi * kIntegration);
  // Displacement of a half sine from rest at its end: A T^2 / (4 pi).
  EXPECT_NEAR(end_of(record)[1], 3 / (4 * pi), 3 / (4 * pi) * kIntegration);
  EXPECT_THAT(h1(record).warnings,
              ElementsAre("h1: this motion does not end at rest where it began: it leaves 0.9549 "
                          "m/s and 0.2387 m"));
}

TEST(Pulses, FullSineIsAStepOfTheGround) {
  const Record record = full_sine(kStep, 3, 1);
  EXPECT_NEAR(peaks_of(record).acceleration, 3, 3 * kIntegration);
  EXPECT_NEAR(peaks_of(record).velocity, 3 / pi, 3 / pi * kIntegration);
  EXPECT_NEAR(end_of(record)[0], 0, 1e-12);
  EXPECT_NEAR(end_of(record)[1], 3 / (2 * pi), 1e-12);
  EXPECT_THAT(h1(record).warnings, ElementsAre(HasSubstr("and 0.4775 m")));
}

// A period that is no whole number of steps moves neither the end velocity nor the step.
TEST(Pulses, EndExactlyForAnyPeriod) {
  const Record record = full_sine(kStep, 3, 1.0023);
  EXPECT_NEAR(end_of(record)[0], 0, 1e-12);
  EXPECT_NEAR(end_of(record)[1], 3 * 1.0023 * 1.0023 / (2 * pi), 1e-12);
  EXPECT_NEAR(peaks_of(record).acceleration, 3, 3 * 1e-3);
}

TEST(Pulses, StepHoldsItsAcceleration) {
  const Record record = acceleration_step(kStep, 2, 0.1, 0.4);
  EXPECT_EQ(peaks_of(record).acceleration, 2);
  EXPECT_EQ((h1(record).acceleration.array() > 2 - 1e-9).count(), 81);
  EXPECT_NEAR(end_of(record)[0], 2 * 0.5, 1e-12);
  EXPECT_THAT(h1(record).warnings, ElementsAre(HasSubstr("leaves 1 m/s")));
}

TEST(Pulses, DoubleImpulseMovesAtItsVelocityInBetween) {
  const Record record = double_impulse(kStep, 0.8, 0.1, 0.5);
  // omega of the half sines is pi / 0.1: (omega dt)^2 / 12 = 0.002.
  EXPECT_NEAR(peaks_of(record).velocity, 0.8, 0.8 * 0.004);
  EXPECT_NEAR(peaks_of(record).acceleration, pi * 0.8 / 0.2, 0.004 * pi * 0.8 / 0.2);
  EXPECT_NEAR(end_of(record)[0], 0, 1e-12);
  EXPECT_NEAR(end_of(record)[1], 0.8 * 0.5, 1e-12);
  EXPECT_ERROR(double_impulse(kStep, 0.8, 0.1, 0.05),
               "interval 0.05 s: must be at least the width of an impulse, 0.1 s");
}

TEST(Pulses, RickerComesBack) {
  const Record record = ricker_wavelet(kStep, 3, 1);
  EXPECT_NEAR(peaks_of(record).acceleration, 3, 3 * 1e-6);
  EXPECT_NEAR(peaks_of(record).time_of_acceleration, 1.5, 1e-9);
  // Its curvature is (2 pi f)^2 3/2 and more at most: 5 times the error of a sine.
  EXPECT_NEAR(peaks_of(record).velocity, 3 / (pi * std::sqrt(2 * std::numbers::e)), 3e-4);
  EXPECT_NEAR(end_of(record).norm(), 0, 1e-12);
  EXPECT_THAT(h1(record).warnings, IsEmpty());
}

// The closed form of v, from the paper, against the integral of the samples of a.
TEST(NearFaultPulse, AccelerationIsTheDerivativeOfTheVelocity) {
  const NearFaultPulse pulse{.amplitude = 0.9, .period = 2, .gamma = 1.7, .phase = 0.4};
  const Record record = near_fault_pulse(kStep, pulse);
  const Eigen::VectorXd& a = h1(record).acceleration;
  double velocity = 0;
  for (Eigen::Index i = 1; i < a.size(); ++i) {
    velocity += kStep / 2 * (a[i - 1] + a[i]);
    const double tau = static_cast<double>(i) * kStep - 1.7;
    const double expected = 0.45 * (1 + std::cos(pi * tau / 1.7)) * std::cos(pi * tau + 0.4);
    // Trapezoids: the error of a sine of frequency (1 + 1 / gamma) / T, and of the correction.
    ASSERT_NEAR(velocity, expected, 0.9 * 2e-4) << tau;
  }
  EXPECT_NEAR(end_of(record)[0], 0, 1e-12);
  EXPECT_NEAR(end_of(record)[1], 0.9 * std::cos(0.4) * std::sin(1.7 * pi) / (pi * (1 - 1.7 * 1.7)),
              1e-12);
  EXPECT_THAT(h1(record).warnings, ElementsAre(HasSubstr("does not end at rest where it began")));
}

TEST(NearFaultPulse, HasThePeakVelocityAndComesBack) {
  const Record symmetric =
      near_fault_pulse(kStep, {.amplitude = 0.9, .period = 2, .gamma = 2, .phase = 0});
  EXPECT_NEAR(peaks_of(symmetric).velocity, 0.9, 0.9 * 2e-4);
  // The integral of v up to its first zero behind the middle, omega tau = pi / 2.
  const double peak =
      0.45 / pi * (1 + std::sin(0.75 * pi) / (2 * 1.5) + std::sin(0.25 * pi) / (2 * 0.5));
  EXPECT_NEAR(peaks_of(symmetric).displacement, peak, peak * 2e-4);
  EXPECT_THAT(h1(symmetric).warnings, IsEmpty());
  const Record odd =
      near_fault_pulse(kStep, {.amplitude = 0.9, .period = 2, .gamma = 1.5, .phase = pi / 2});
  EXPECT_NEAR(end_of(odd).norm(), 0, 1e-12);
  EXPECT_THAT(h1(odd).warnings, IsEmpty());
}

}  // namespace
}  // namespace gurney::groundmotions
