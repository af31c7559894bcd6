#include <gtest/gtest.h>

#include <cmath>

#include "groundmotions/measures/response_spectrum.h"

namespace gurney::groundmotions {
namespace {

// A constant load p from rest: u = p / w^2 (1 - exp(-z w t) (cos(wd t) + z w / wd sin(wd t))).
TEST(Oscillator, AnswersAConstantLoadExactly) {
  const double w = 7, z = 0.3, wd = w * std::sqrt(1 - z * z), step = 0.13;
  Oscillator oscillator(w, z, step);
  for (int i = 1; i <= 20; ++i) {
    oscillator.step(2, 2);
    const double t = i * step;
    const double u =
        2 / (w * w) *
        (1 - std::exp(-z * w * t) * (std::cos(wd * t) + z * w / wd * std::sin(wd * t)));
    const double v = 2 / wd * std::exp(-z * w * t) * std::sin(wd * t);
    EXPECT_NEAR(oscillator.displacement(), u, 1e-15);
    EXPECT_NEAR(oscillator.velocity(), v, 1e-14);
  }
}

// A load that grows as r t, undamped, from rest: u = r / w^2 (t - sin(w t) / w).
TEST(Oscillator, AnswersARampExactly) {
  const double w = 5, step = 0.2, r = 3;
  Oscillator oscillator(w, 0, step);
  for (int i = 1; i <= 20; ++i) {
    oscillator.step(r * (i - 1) * step, r * i * step);
    const double t = i * step;
    EXPECT_NEAR(oscillator.displacement(), r / (w * w) * (t - std::sin(w * t) / w), 1e-14);
    EXPECT_NEAR(oscillator.velocity(), r / (w * w) * (1 - std::cos(w * t)), 1e-14);
  }
}

// In a step far below the period the mass moves freely: by p0 dt^2 / 3 + p1 dt^2 / 6 but for
// terms of (omega dt)^2.
TEST(Oscillator, KeepsItsDigitsInVeryShortSteps) {
  const double omega = 6, step = 1e-6;
  const OscillatorStep s = oscillator_step(omega, 0, step);
  EXPECT_NEAR(s.u_p0 / (step * step / 3), 1, 1e-11);  // (omega dt)^2 / 20
  EXPECT_NEAR(s.u_p1 / (step * step / 6), 1, 1e-11);
  EXPECT_NEAR(s.v_p0 / (step / 2), 1, 1e-11);
  EXPECT_NEAR(s.v_p1 / (step / 2), 1, 1e-11);
}

// The two ways to the weights, closed form and power series, meet where |lambda dt| = 1.
TEST(Oscillator, HasNoJumpBetweenItsTwoFormulas) {
  const OscillatorStep below = oscillator_step(1, 0.1, 1 - 1e-12);
  const OscillatorStep above = oscillator_step(1, 0.1, 1 + 1e-12);
  EXPECT_NEAR(below.u_p0, above.u_p0, 4e-12);
  EXPECT_NEAR(below.u_p1, above.u_p1, 4e-12);
  EXPECT_NEAR(below.v_p0, above.v_p0, 4e-12);
  EXPECT_NEAR(below.v_p1, above.v_p1, 4e-12);
}

}  // namespace
}  // namespace gurney::groundmotions
