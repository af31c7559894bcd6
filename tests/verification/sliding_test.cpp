#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/units.h"
#include "engine/simulate.h"
#include "studies/verification/scenes/scenes.h"
#include "studies/verification/scenes/wind_up.h"

// A trolley on locked, rigid casters is a block on a Coulomb contact; one that rolls straight is a
// block with mu = Cr / R whose relative accelerations are all scaled by M / (M + J), J = sum I_w /
// R^2. Rotations are held where the closed form knows none. Treads are stiffer still than
// elsewhere: what winding up adds at every reversal is of the order mu M g / sqrt(k M), 5e-5 m/s at
// most.
namespace gurney {
namespace {

using namespace scenes;

constexpr double kG = kStandardGravity;
constexpr double kTangential = 1e11;  // [N/m]
constexpr double kTwoPi = 2 * std::numbers::pi;

EquipmentModel block(double mu) {
  ItemOptions options;
  stiffen(options.caster.tread);
  options.caster.tread.tangential_stiffness = kTangential;
  options.caster.tread.static_friction = options.caster.tread.kinetic_friction = mu;
  return locked_block(options);
}

EquipmentModel rolling_cart(double resistance) {
  ItemOptions options;
  stiffen(options.caster.tread);
  options.caster.tread.tangential_stiffness = kTangential;
  options.caster.tread.rolling_resistance = resistance * options.caster.wheel_radius;
  options.caster.swivels = false;
  return trolley(options);
}

double share_of_inertia(const EquipmentModel& item) {
  return total_mass(item) / (total_mass(item) + wheel_inertia_mass(item));
}

/// A block, or a cart with Cr / R = mu, and the scale of its motion against the block's.
struct Slider {
  EquipmentModel item;
  double scale;
};

Slider slider(bool rolls, double mu) {
  if (!rolls) return {block(mu), 1};
  EquipmentModel cart = rolling_cart(mu);
  const double scale = share_of_inertia(cart);
  return {std::move(cart), scale};
}

Response shake(const EquipmentModel& item, const FloorMotion& floor, const SimulationSettings& run,
               double speed = 0) {
  Scene scene;
  scene.items[0].model = item;
  scene.items[0].initial.velocity.x() = speed;
  scene.items[0].initial.wheels_roll = item.casters[0].brake_torque == 0;
  Excitation excitation;
  excitation.floor = floor;
  excitation.fixture = hold_rotations();
  return simulate(scene, excitation, run);
}

struct Harmonic {
  double mu, amplitude, frequency;  // [-], [g], [Hz]
};

/// Steady peak-to-peak displacement of a Coulomb block on a base A sin(w t): Westermo & Udwadia
/// 1983, Earthquake Eng. Struct. Dyn. 11:135; Shao & Tung 1999. With eta = mu g / A:
/// eta < 1 / sqrt(1 + pi^2 / 4): always slides, (2 A / w^2) sqrt(1 - (pi eta / 2)^2);
/// eta < 1: sticks twice a cycle, slides from sin t1 = eta to the next stop t2.
double peak_to_peak(const Harmonic& h) {
  const double a = h.amplitude * kG, w = kTwoPi * h.frequency, eta = h.mu / h.amplitude;
  if (eta < 1 / std::sqrt(1 + std::numbers::pi * std::numbers::pi / 4))
    return 2 * a / (w * w) * std::sqrt(1 - std::pow(std::numbers::pi * eta / 2, 2));
  const double t1 = std::asin(eta);
  const auto speed = [&](double t) { return std::cos(t) - std::cos(t1) + eta * (t - t1); };
  double low = t1 + 0.1, high = t1 + kTwoPi;  // one stop between: speed changes sign once
  while (high - low > 1e-14) {
    const double middle = (low + high) / 2;
    (speed(middle) < 0 ? low : high) = middle;
  }
  const double d = low - t1;
  return a / (w * w) * std::abs(std::sin(low) - std::sin(t1) - d * std::cos(t1) + eta * d * d / 2);
}

TEST(Westermo, FormulaGivesPublishedNumbers) {
  // Independent high-resolution integration, 1 Hz, g = 9.81 (numbers to the digits shown).
  const double scale = 9.81 / kG;
  EXPECT_NEAR(scale * peak_to_peak({0.03, 0.5, 1}), 0.24738, 5e-6);
  EXPECT_NEAR(scale * peak_to_peak({0.3, 0.4, 1}), 0.02950, 5e-6);
  EXPECT_NEAR(scale * peak_to_peak({0.3, 0.5, 1}), 0.09795, 5e-6);
  EXPECT_NEAR(scale * peak_to_peak({0.5, 0.6, 1}), 0.01930, 5e-6);
}

class HarmonicFloor : public testing::TestWithParam<Harmonic> {};

/// Relative velocity in steady motion at t = 0. A block that always slides has, against the mean of
/// the floor's, the triangular velocity of slopes +-mu g; the floor's is -A / w cos(w t). They meet
/// at w t = acos(pi eta / 2) and half a period later. One that sticks forgets its start.
double steady_start(const Harmonic& h) {
  const double a = h.amplitude * kG, w = kTwoPi * h.frequency;
  const double cosine = std::numbers::pi * h.mu / h.amplitude / 2;
  if (cosine > 1) return a / w;
  return a / w - h.mu * kG / w * (std::numbers::pi / 2 - std::acos(cosine));
}

constexpr double kStep = 1e-4, kSampling = 1e-3;  // [s]

double measured_peak_to_peak(const Slider& s, const Harmonic& h) {
  const double w = kTwoPi * h.frequency, duration = 4 / h.frequency;
  const FloorMotion floor = floor_motion(0.001, duration, Vector3::UnitX(), [&](double t) {
    return h.amplitude * kG * std::sin(w * t);
  });
  const auto response =
      shake(s.item, floor, run_for(duration, kStep, kSampling), s.scale * steady_start(h));
  double low = 1e9, high = -1e9;
  for (const Sample& sample : response.items[0].history) {
    if (sample.time < duration - 1.5 / h.frequency) continue;
    low = std::min(low, sample.displacement.x());
    high = std::max(high, sample.displacement.x());
  }
  return high - low;
}

// What is left: a reversal met inside a step takes the friction after it for the whole step, 2 mu g
// dt at most, and that speed lasts for half a cycle; the speed that winding up adds does as well;
// the extremes fall between samples; the sampled sine is off by (w dt)^2 / 12.
TEST_P(HarmonicFloor, MovesBlockAndCartByTheClosedForm) {
  const Harmonic h = GetParam();
  const double period = 1 / h.frequency;
  for (const bool rolls : {false, true}) {
    SCOPED_TRACE(rolls ? "cart" : "block");
    const Slider s = slider(rolls, h.mu);
    const double exact = s.scale * peak_to_peak(h);
    const double reversal = 2 * h.mu * kG * kStep;
    const double wind_up = h.mu * kG * std::sqrt(total_mass(s.item) / (4 * kTangential * 10 / 11));
    const double sampling = (h.amplitude + h.mu) * kG * kSampling * kSampling / 4;
    EXPECT_NEAR(measured_peak_to_peak(s, h), exact,
                (reversal + wind_up) * period / 2 + sampling + 1e-5 * exact);
  }
}

INSTANTIATE_TEST_SUITE_P(Floors, HarmonicFloor,
                         testing::Values(Harmonic{0.03, 0.5, 1}, Harmonic{0.3, 0.4, 1},
                                         Harmonic{0.3, 0.5, 1}, Harmonic{0.15, 0.5, 2},
                                         Harmonic{0.1, 0.25, 0.5}, Harmonic{0.5, 0.6, 1}));

TEST(HarmonicFloor, MovesNothingBelowTheThreshold) {
  for (const bool rolls : {false, true}) {
    const double mu = rolls ? 0.02 : 0.3;
    const Slider s = slider(rolls, mu);
    const FloorMotion floor = floor_motion(0.001, 10, Vector3::UnitX(), [&](double t) {
      return 0.95 * mu * kG * std::sin(kTwoPi * t) * std::min(1.0, t);
    });
    EXPECT_LT(shake(s.item, floor, run_for(10, 0.002)).items[0].demands.peak_displacement, 3e-7);
  }
}

struct Pulse {
  double mu, amplitude, duration;  // [-], [g], [s]
};

class RectangularPulse : public testing::TestWithParam<Pulse> {};

// Newmark 1965, Geotechnique 15:139: a floor that accelerates at A for t0 and then keeps its speed
// V = A t0 leaves a block of yield acceleration N = mu g behind by D = V^2 / (2 N) (1 - N / A).
// The speed that winding up adds (wind_up.h) lasts for the whole slide, V / N.
TEST_P(RectangularPulse, LeavesNewmarksDisplacement) {
  const Pulse p = GetParam();
  for (const bool rolls : {false, true}) {
    SCOPED_TRACE(rolls ? "cart" : "block");
    const Slider s = slider(rolls, p.mu);
    const double a = p.amplitude * kG, yield = p.mu * kG, speed = a * p.duration;
    const double exact = s.scale * speed * speed / (2 * yield) * (1 - yield / a);
    const double mass = total_mass(s.item), k = 4 * kTangential * 10 / 11;
    const double tolerance =
        wind_up_speed(mass * a, mass * yield, k, mass) * speed / yield + 1e-6 * exact;
    for (const double time_step : {0.004, 0.0005}) {
      const auto response =
          shake(s.item, rectangular_pulse(a, p.duration), run_for(speed / yield + 1, time_step));
      EXPECT_NEAR(response.items[0].demands.residual_displacement_x, -exact, tolerance);
      EXPECT_NEAR(response.items[0].demands.peak_displacement, exact, tolerance);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Pulses, RectangularPulse,
                         testing::Values(Pulse{0.1, 0.5, 0.3},     // 0.8829 m at g = 9.81
                                         Pulse{0.03, 0.4, 0.25},   // 1.512375 m at g = 9.81
                                         Pulse{0.2, 0.35, 0.415},  // no whole number of steps
                                         Pulse{0.02, 0.1, 0.5}));

class HalfSinePulse : public testing::TestWithParam<Pulse> {};

// A half-sine pulse a sin(w t), t < T: the block starts at sin(w t1) = mu g / a, has the speed
// v = a / w (cos(w t1) + 1) - mu g (T - t1) at its end and slides on for v^2 / (2 mu g).
// mu = 0.05, a = 0.5 g, T = 0.5 s: 2.107004 m at g = 9.81.
TEST_P(HalfSinePulse, LeavesNewmarksDisplacement) {
  const Pulse p = GetParam();
  const double a = p.amplitude * kG, yield = p.mu * kG, T = p.duration;
  const double w = std::numbers::pi / T, t1 = std::asin(p.mu / p.amplitude) / w;
  const double v = a / w * (std::cos(w * t1) + 1) - yield * (T - t1);
  ASSERT_GT(v, 0);
  const double during = a / w * (T - t1) * std::cos(w * t1) + a / (w * w) * std::sin(w * t1) -
                        yield * (T - t1) * (T - t1) / 2;
  const double block_distance = during + v * v / (2 * yield);
  for (const bool rolls : {false, true}) {
    SCOPED_TRACE(rolls ? "cart" : "block");
    const Slider s = slider(rolls, p.mu);
    const FloorMotion floor =
        floor_motion(T / 1000, T, Vector3::UnitX(), [&](double t) { return a * std::sin(w * t); });
    const auto response = shake(s.item, floor, run_for(T + v / yield + 1, 0.001));
    // The sampled sine has (pi / 1000)^2 / 12 less area; the start is met inside a step.
    EXPECT_NEAR(response.items[0].demands.residual_displacement_x, -s.scale * block_distance,
                2e-5 * block_distance);
  }
}

INSTANTIATE_TEST_SUITE_P(Pulses, HalfSinePulse,
                         testing::Values(Pulse{0.05, 0.5, 0.5}, Pulse{0.3, 0.8, 0.3},
                                         Pulse{0.02, 0.2, 1}));

TEST(HalfSinePulseFormula, GivesTheIndependentNumber) {
  const double a = 0.5 * 9.81, yield = 0.05 * 9.81, T = 0.5, w = std::numbers::pi / T;
  const double t1 = std::asin(0.1) / w, v = a / w * (std::cos(w * t1) + 1) - yield * (T - t1);
  const double during = a / w * (T - t1) * std::cos(w * t1) + a / (w * w) * std::sin(w * t1) -
                        yield * (T - t1) * (T - t1) / 2;
  EXPECT_NEAR(during + v * v / (2 * yield), 2.107004, 5e-7);
}

}  // namespace
}  // namespace gurney
