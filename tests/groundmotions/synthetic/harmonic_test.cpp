#include "groundmotions/synthetic/harmonic.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "groundmotions/measures/peaks.h"
#include "groundmotions/synthetic/component.h"
#include "groundmotions/synthetic/noise.h"
#include "tests/support/expect_error.h"

namespace gurney::groundmotions {
namespace {

using std::numbers::pi;
using testing::IsEmpty;

const Component& h1(const Record& record) { return *record[Direction::kH1]; }

int zero_crossings(const Eigen::VectorXd& a, double step, double from, double to) {
  int count = 0;
  for (auto i = static_cast<Eigen::Index>(from / step) + 1;
       i < static_cast<Eigen::Index>(to / step); ++i)
    count += a[i] * a[i - 1] < 0;
  return count;
}

TEST(Harmonic, HasItsAmplitudeAndEndsAtRest) {
  const Record record =
      harmonic(0.005, {.peak_acceleration = 2, .frequency = 1.5, .duration = 20, .taper = 3});
  const Peaks p = peaks(0.005, h1(record).acceleration);
  EXPECT_DOUBLE_EQ(p.acceleration, 2);
  // Steady sine: A / omega and A / omega^2, no drift; integrated to (omega dt)^2 / 12 = 2e-4. A
  // taper of 3 s adds less than (0.5 pi / 3)^2 2 / omega^2 = 0.6 % to the acceleration.
  EXPECT_NEAR(p.velocity, 2 / (3 * pi), 0.008 * 2 / (3 * pi));
  EXPECT_NEAR(p.displacement, 2 / (9 * pi * pi), 0.008 * 2 / (9 * pi * pi));
  EXPECT_LT(end_state(0.005, h1(record).acceleration).norm(), 1e-12);
  EXPECT_THAT(h1(record).warnings, IsEmpty());
  EXPECT_NEAR(zero_crossings(h1(record).acceleration, 0.005, 5, 15), 30, 1);
  EXPECT_ERROR(harmonic(0.05, {.peak_acceleration = 2, .frequency = 5, .duration = 20, .taper = 3}),
               "frequency 5 Hz at time step 0.05 s: must be at most 4 Hz");
  EXPECT_ERROR(
      harmonic(0.005, {.peak_acceleration = 2, .frequency = 5, .duration = 20, .taper = 11}),
      "taper 11 s: must be > 0 and at most half the duration, 10 s");
}

// The number of half cycles up to t is phi(t) / pi: at half time for 1 to 9 Hz in 40 s, linear
// 2 (1 * 20 + 8 * 400 / 80) = 120; logarithmic 2 * 40 / ln 9 (3 - 1) = 72.8.
TEST(Sweep, RunsThroughItsFrequencies) {
  Sweep motion{.peak_acceleration = 2,
               .first_frequency = 1,
               .last_frequency = 9,
               .duration = 40,
               .taper = 2};
  const Record linear = sweep(0.005, motion);
  EXPECT_NEAR(zero_crossings(h1(linear).acceleration, 0.005, 0, 20), 120, 1);
  motion.logarithmic = true;
  const Record logarithmic = sweep(0.005, motion);
  EXPECT_NEAR(zero_crossings(h1(logarithmic).acceleration, 0.005, 0, 20), 72.8, 1.5);
  for (const Record* record : {&linear, &logarithmic}) {
    EXPECT_DOUBLE_EQ(peaks(0.005, h1(*record).acceleration).acceleration, 2);
    EXPECT_LT(end_state(0.005, h1(*record).acceleration).norm(), 1e-12);
    EXPECT_THAT(h1(*record).warnings, IsEmpty());
  }
  motion.last_frequency = 1;
  EXPECT_ERROR(sweep(0.005, motion), "needs two different frequencies");
}

WhiteNoise noise() {
  return {.seed = 5,
          .lowest_frequency = 2,
          .highest_frequency = 6,
          .duration = 30,
          .taper = 3,
          .peak_acceleration = {4, 3, 0}};
}

TEST(WhiteNoise, HasItsPeaksAndEndsAtRest) {
  const Record record = white_noise(0.005, noise());
  EXPECT_FALSE(record[Direction::kVertical]);
  EXPECT_DOUBLE_EQ(peaks(0.005, h1(record).acceleration).acceleration, 4);
  EXPECT_DOUBLE_EQ(record[Direction::kH2]->acceleration.cwiseAbs().maxCoeff(), 3);
  EXPECT_LT(end_state(0.005, h1(record).acceleration).norm(), 1e-12);
  // Rice (1944): 2 sqrt(lambda_2 / lambda_0) crossings in a second, for a flat band from 2 to 6 Hz
  // 2 sqrt((6^3 - 2^3) / (3 * 4)) = 8.33; in 24 s 200. About 2 * 4 * 24 independent values give a
  // scatter of some sqrt(200) * 0.3 = 4; 4 of these.
  EXPECT_NEAR(zero_crossings(h1(record).acceleration, 0.005, 3, 27), 200, 16);
}

TEST(WhiteNoise, DependsOnTheSeedOnly) {
  WhiteNoise motion = noise();
  const Eigen::VectorXd first = h1(white_noise(0.005, motion)).acceleration;
  EXPECT_EQ(first, h1(white_noise(0.005, motion)).acceleration);
  motion.seed = 6;
  const Eigen::VectorXd second = h1(white_noise(0.005, motion)).acceleration;
  // 2 * 4 Hz * 27 s = 216 independent values: the correlation scatters by 0.07; 4 of these.
  EXPECT_LT(std::abs(first.dot(second)), 0.28 * first.norm() * second.norm());
}

TEST(WhiteNoise, RefusesABandThatDoesNotFit) {
  WhiteNoise motion = noise();
  motion.highest_frequency = 90;
  EXPECT_ERROR(white_noise(0.005, motion), "must be an interval below 80 Hz");
  motion = noise();
  motion.peak_acceleration[0] = motion.peak_acceleration[1] = 0;
  EXPECT_ERROR(white_noise(0.005, motion), "at least one peak must be > 0");
}

// The amplitude of one line is what was asked for, the scale of the transform included.
TEST(FourierNoise, IsTheSumItClaimsToBe) {
  const FourierNoise source(3, 0, 1024, 0.01);
  const double f = 16 / 10.24;
  const auto line = [&](double at) { return std::abs(at - f) < 1e-6 ? 1. : 0.; };
  const Eigen::VectorXd x = source.shaped(line);
  // u^2 + v^2 from the two quarter phases of the only line.
  const double u = x[0], v = x[16];
  const Eigen::VectorXd doubled = source.shaped([&](double at) { return 2 * line(at); });
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const double phase = 2 * pi * f * 0.01 * static_cast<double>(i);
    ASSERT_NEAR(x[i], u * std::cos(phase) + v * std::sin(phase), 1e-12);
    ASSERT_NEAR(doubled[i], 2 * x[i], 1e-12);
  }
  // All 510 lines: the variance is their number, its scatter sqrt(2 / 1020) relative; 4 of these.
  const Eigen::VectorXd all = source.shaped([](double) { return 1.; });
  EXPECT_NEAR(all.squaredNorm() / 1024, 511, 4 * 511 * 0.0443);
}

}  // namespace
}  // namespace gurney::groundmotions
