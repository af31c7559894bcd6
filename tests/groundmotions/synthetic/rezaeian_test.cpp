#include "groundmotions/synthetic/rezaeian.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "engine/base/units.h"
#include "groundmotions/synthetic/component.h"
#include "tests/support/expect_error.h"

namespace gurney::groundmotions {
namespace {

using std::numbers::pi;

StochasticMotion motion() {
  StochasticMotion m{.seed = 1, .time_step = 0.01, .corner_frequency = 0.1, .components = {}};
  m.components[0] = {.arias_intensity = 1.2,
                     .duration = 12,
                     .middle = 8,
                     .frequency = 5,
                     .frequency_slope = -0.1,
                     .damping = 0.3};
  return m;
}

// Shape 1 is the exponential distribution: quantiles -ln(1 - p).
TEST(GammaEnvelope, HasTheDurationAndTheMiddle) {
  EXPECT_NEAR(gamma_time({1, 2}, 0.45), -std::log(0.55) / 2, 1e-12);
  const GammaEnvelope envelope = gamma_envelope(12, 8);
  EXPECT_NEAR(gamma_time(envelope, 0.95) - gamma_time(envelope, 0.05), 12, 1e-9);
  EXPECT_NEAR(gamma_time(envelope, 0.45), 8, 1e-9);
  EXPECT_ERROR(gamma_envelope(4.5 * 8, 8), "must be less than 4.5 times");
  EXPECT_ERROR(gamma_envelope(40, 8),
               "significant duration 40 s: must be less than 4.5 times the time of the middle of "
               "strong shaking, 8 s");
  EXPECT_ERROR(gamma_envelope(0.001, 8), "is too short for the time of the middle");
}

/// Mean of samples and four times its standard error.
struct Estimate {
  std::vector<double> values;
  double mean() const {
    double sum = 0;
    for (const double v : values) sum += v;
    return sum / static_cast<double>(values.size());
  }
  double four_errors() const {
    double sum = 0;
    for (const double v : values) sum += (v - mean()) * (v - mean());
    const auto n = static_cast<double>(values.size());
    return 4 * std::sqrt(sum / (n - 1) / n);
  }
};

TEST(StochasticMotion, HasItsEnergyAndFrequencyOnAverage) {
  StochasticMotion m = motion();
  const StochasticComponent& c = m.components[0];
  const GammaEnvelope envelope = gamma_envelope(c.duration, c.middle);
  const double times[] = {gamma_time(envelope, 0.05), gamma_time(envelope, 0.45),
                          gamma_time(envelope, 0.95)};
  Estimate arias, share[3], crossings[2];
  for (m.seed = 1; m.seed <= 150; ++m.seed) {
    const Eigen::VectorXd a = stochastic_motion(m)[Direction::kH1]->acceleration;
    const double total = a.squaredNorm();
    arias.values.push_back(pi / (2 * kStandardGravity) * total * m.time_step);
    for (int k = 0; k < 3; ++k)
      share[k].values.push_back(
          a.head(static_cast<Eigen::Index>(times[k] / m.time_step) + 1).squaredNorm() / total);
    for (int k = 0; k < 2; ++k) {
      double count = 0;
      for (auto i = static_cast<Eigen::Index>(times[k] / m.time_step) + 1;
           i <= static_cast<Eigen::Index>(times[k + 1] / m.time_step); ++i)
        count += a[i - 1] < 0 && a[i] >= 0;
      crossings[k].values.push_back(count);
    }
  }
  // The high-pass takes 3 pi f_c / 4 off an area of pi f / (4 zeta) under a spectrum that is flat
  // towards zero: 3 zeta f_c / f = 1.8 %.
  EXPECT_NEAR(arias.mean(), 1.2, arias.four_errors() + 0.018 * 1.2);
  EXPECT_LT(arias.four_errors(), 0.12 * 1.2);
  // One sample of 1200 more or less.
  const double wanted[] = {0.05, 0.45, 0.95};
  for (int k = 0; k < 3; ++k)
    EXPECT_NEAR(share[k].mean(), wanted[k], share[k].four_errors() + 1 / 1200.);
  // Up-crossings of a sampled Gaussian process: arccos(rho(dt)) / (2 pi dt), with the correlation
  // of an oscillator under white noise; 0.9 % more without what the high-pass takes off.
  for (int k = 0; k < 2; ++k) {
    double expected = 0;
    for (double t = times[k]; t < times[k + 1]; t += m.time_step) {
      const double omega = 2 * pi * (c.frequency + c.frequency_slope * (t - c.middle));
      const double damped = std::sqrt(1 - c.damping * c.damping);
      const double rho = std::exp(-c.damping * omega * m.time_step) *
                         (std::cos(damped * omega * m.time_step) +
                          c.damping / damped * std::sin(damped * omega * m.time_step));
      expected += std::acos(rho) / (2 * pi);
    }
    EXPECT_NEAR(crossings[k].mean(), 1.0045 * expected,
                crossings[k].four_errors() + 0.0045 * expected + 1);
  }
}

TEST(StochasticMotion, EndsAtRestAndDependsOnTheSeedOnly) {
  StochasticMotion m = motion();
  m.components[2] = m.components[0];
  const Record first = stochastic_motion(m);
  EXPECT_EQ(first[Direction::kH1]->acceleration,
            stochastic_motion(m)[Direction::kH1]->acceleration);
  EXPECT_FALSE(first[Direction::kH2]);
  EXPECT_LT(end_state(m.time_step, first[Direction::kH1]->acceleration).norm(), 1e-11);
  EXPECT_THAT(first[Direction::kH1]->warnings, testing::IsEmpty());
  const auto correlation = [](const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
    return std::abs(a.dot(b)) / (a.norm() * b.norm());
  };
  // A half-power band of pi zeta f = 4.7 Hz and 12 s: 2 * 4.7 * 12 = 113 values, 0.094; 4 of these.
  EXPECT_LT(
      correlation(first[Direction::kH1]->acceleration, first[Direction::kVertical]->acceleration),
      0.38);
}

TEST(StochasticMotion, RefusesWhatItCannotMake) {
  StochasticMotion m = motion();
  m.components[0].frequency = 30;
  EXPECT_ERROR(stochastic_motion(m), "frequency 30 Hz at time step 0.01 s: must be at most 25 Hz");
  m.components[0].arias_intensity = 0;
  EXPECT_ERROR(stochastic_motion(m), "needs a component with an Arias intensity > 0");
}

}  // namespace
}  // namespace gurney::groundmotions
