#include <algorithm>
#include <cmath>
#include <numbers>

#include "studies/verification/cases/slider.h"
#include "studies/verification/family.h"
#include "studies/verification/gravity.h"
#include "studies/verification/scenes/scenes.h"

namespace gurney::verification {
namespace {

using namespace sliding;

constexpr double kPi = std::numbers::pi;
constexpr double kStep = 1e-4, kSampling = 1e-3;  // [s]

struct Harmonic {
  double rolls, friction, amplitude, frequency;  // cart or block, mu, [g], [Hz]
};

/// Steady peak-to-peak displacement over g [s2]. With eta = mu g / A: below 1 / sqrt(1 + pi^2 / 4)
/// it always slides; else it sticks twice a cycle and slides from sin t1 = eta to its next stop.
double peak_to_peak(double friction, double amplitude, double frequency) {
  const double w = 2 * kPi * frequency, eta = friction / amplitude;
  if (eta < 1 / std::sqrt(1 + kPi * kPi / 4))
    return 2 * amplitude / (w * w) * std::sqrt(1 - std::pow(kPi * eta / 2, 2));
  const double t1 = std::asin(eta);
  const auto speed = [&](double t) { return std::cos(t) - std::cos(t1) + eta * (t - t1); };
  double low = t1 + 0.1, high = t1 + 2 * kPi;  // one stop between: speed changes sign once
  while (high - low > 1e-14 * high) {
    const double middle = (low + high) / 2;
    if (middle == low || middle == high) break;
    (speed(middle) < 0 ? low : high) = middle;
  }
  const double d = low - t1;
  return amplitude / (w * w) *
         std::abs(std::sin(low) - std::sin(t1) - d * std::cos(t1) + eta * d * d / 2);
}

/// Relative velocity in steady motion at t = 0. A block that always slides has, against the mean of
/// the floor's, the triangular velocity of slopes +-mu g; the floor's is -A / w cos(w t). They meet
/// at w t = acos(pi eta / 2) and half a period later. One that sticks forgets its start.
double steady_start(const Harmonic& h) {
  const double a = h.amplitude * kG, w = 2 * kPi * h.frequency;
  const double cosine = kPi * h.friction / h.amplitude / 2;
  if (cosine > 1) return a / w;
  return a / w - h.friction * kG / w * (kPi / 2 - std::acos(cosine));
}

Findings slip(const Harmonic& h, const Runner& runner) {
  Findings findings;
  const Slider slider = make_slider(h.rolls != 0, h.friction);
  const double w = 2 * kPi * h.frequency, duration = 4 / h.frequency;
  const FloorMotion floor = scenes::floor_motion(0.001, duration, Vector3::UnitX(), [&](double t) {
    return h.amplitude * kG * std::sin(w * t);
  });
  const Response response = shake(slider, floor, scenes::run_for(duration, kStep, kSampling),
                                  slider.scale * steady_start(h), runner, findings);
  double low = INFINITY, high = -INFINITY;
  for (const Sample& s : response.items[0].history) {
    if (s.time < duration - 1.5 / h.frequency) continue;
    low = std::min(low, s.displacement.x());
    high = std::max(high, s.displacement.x());
  }
  const double exact = slider.scale * kG * peak_to_peak(h.friction, h.amplitude, h.frequency);
  const double reversal = 2 * h.friction * kG * kStep;
  const double sampling = (h.amplitude + h.friction) * kG * kSampling * kSampling / 4;
  findings.checks.push_back(
      {"steady displacement, peak to peak", "m", high - low, exact,
       (reversal + slider.wind_up) / (2 * h.frequency) + sampling + std::pow(w * 0.001, 2) * exact,
       "a reversal inside a step takes the friction after it for all of it, 2 mu g dt, and treads "
       "wind up, mu g sqrt(M/k), for half a cycle; extremes between samples, (A + mu g) dt_s^2 / "
       "4; "
       "the sampled sine, (w dt_f)^2"});

  const FloorMotion gentle =
      scenes::floor_motion(0.001, 5 / h.frequency, Vector3::UnitX(), [&](double t) {
        return 0.95 * h.friction * kG * std::sin(w * t) * std::min(1.0, t * h.frequency);
      });
  const Response still =
      shake(slider, gentle, scenes::run_for(5 / h.frequency, 0.002), 0, runner, findings);
  const double sway = 0.95 * h.friction * kG * scenes::total_mass(slider.item) / slider.stiffness;
  findings.checks.push_back({"peak displacement at 0.95 of the threshold", "m",
                             still.items[0].demands.peak_displacement, 0, 2 * sway + 1e-10,
                             "sway of the treads, M a / k, at most twice; 1e-10 m for rounding"});
  return findings;
}

bool slides(const Harmonic& h) {
  return h.amplitude > 1.1 * h.friction && h.amplitude < 25 * h.friction;
}

struct Published {
  double friction, amplitude, frequency, displacement;  // over g [s2]
};

Findings published(const Published& p, const Runner&) {
  return {
      {{"formula, peak to peak over g", "s2", peak_to_peak(p.friction, p.amplitude, p.frequency),
        p.displacement, 5.1e-7, "the digits of the independent integration"}},
      {}};
}

}  // namespace

Family harmonic_slip() {
  return make_family<Harmonic>(
      {"harmonic_slip", "sliding", "Sliding on a floor that swings harmonically",
       "eta = mu g / A < 1/sqrt(1 + pi^2/4): (2 A/w^2) sqrt(1 - (pi eta/2)^2), else stick and slip "
       "from sin t1 = eta to the next stop; a cart with mu = Cr/R: times M / (M + J)",
       "Westermo & Udwadia 1983, Earthquake Eng. Struct. Dyn. 11:135; Shao & Tung 1999"},
      {{{"rolls", "0 block, 1 cart", 0, 1, true}, &Harmonic::rolls},
       {{"friction", "mu or Cr/R", 0.02, 0.5}, &Harmonic::friction},
       {{"amplitude", "g", 0.1, 0.8}, &Harmonic::amplitude},
       {{"frequency", "Hz", 0.4, 3}, &Harmonic::frequency}},
      {{"block_slippery", {0, 0.03, 0.5, 1}},
       {"block_near_stick", {0, 0.3, 0.4, 1}},
       {"block_stick", {0, 0.3, 0.5, 1}},
       {"block_2_Hz", {0, 0.15, 0.5, 2}},
       {"block_half_Hz", {0, 0.1, 0.25, 0.5}},
       {"block_rough", {0, 0.5, 0.6, 1}},
       {"cart_slippery", {1, 0.03, 0.5, 1}},
       {"cart_near_stick", {1, 0.3, 0.4, 1}},
       {"cart_stick", {1, 0.3, 0.5, 1}},
       {"cart_2_Hz", {1, 0.15, 0.5, 2}},
       {"cart_half_Hz", {1, 0.1, 0.25, 0.5}},
       {"cart_rough", {1, 0.5, 0.6, 1}}},
      slip, slides);
}

Family harmonic_slip_formula() {
  Family family = make_family<Published>(
      {"harmonic_slip_formula", "sliding", "The formula of harmonic_slip gives known numbers",
       "as harmonic_slip", "an independent integration with a high resolution"},
      {{{"friction", "mu", 0, 1}, &Published::friction},
       {{"amplitude", "g", 0, 1}, &Published::amplitude},
       {{"frequency", "Hz", 1, 1}, &Published::frequency},
       {{"displacement", "s2", 0, 1}, &Published::displacement}},
      {{"slippery", {0.03, 0.5, 1, 0.0252171}},
       {"near_stick", {0.3, 0.4, 1, 0.0030071}},
       {"stick", {0.3, 0.5, 1, 0.0099847}},
       {"rough", {0.5, 0.6, 1, 0.0019674}}},
      published);
  family.drawn = false;
  return family;
}

}  // namespace gurney::verification
