#include <cmath>
#include <numbers>

#include "studies/verification/cases/slider.h"
#include "studies/verification/family.h"
#include "studies/verification/gravity.h"
#include "studies/verification/scenes/scenes.h"
#include "studies/verification/scenes/wind_up.h"

// Newmark 1965, Geotechnique 15:139: a floor that accelerates for a while and then keeps its speed
// leaves a block of yield acceleration mu g behind.
namespace gurney::verification {
namespace {

using namespace sliding;

struct Pulse {
  double rolls, friction, amplitude, duration;  // cart or block, mu, [g], [s]
};

bool slides(const Pulse& p) {
  return p.amplitude > 1.5 * p.friction && p.amplitude < 25 * p.friction;
}

Findings rectangular(const Pulse& p, const Runner& runner) {
  Findings findings;
  const Slider slider = make_slider(p.rolls != 0, p.friction);
  const double a = p.amplitude * kG, yield = p.friction * kG, speed = a * p.duration;
  const double exact = slider.scale * speed * speed / (2 * yield) * (1 - yield / a);
  const double mass = scenes::total_mass(slider.item);
  const double wound =
      2 * wind_up_speed(mass * a, mass * yield, slider.stiffness, mass) * speed / yield;
  const char* const terms =
      "twice the speed that winding up adds (constant_pull) lasts for the whole slide, V / (mu g); "
      "the stop "
      "inside a step, mu g dt^2; 1e-6 of it for the solve";
  for (const double step : {0.004, 0.0005}) {
    const double tolerance = wound + yield * step * step + 1e-6 * exact;
    const Response response = shake(slider, scenes::rectangular_pulse(a, p.duration),
                                    scenes::run_for(speed / yield + 1, step), 0, runner, findings);
    const std::string how = step == 0.004 ? ", 4 ms" : ", 0.5 ms";
    findings.checks.push_back({"displacement left" + how, "m",
                               response.items[0].demands.residual_displacement_x, -exact, tolerance,
                               terms});
    findings.checks.push_back({"peak displacement" + how, "m",
                               response.items[0].demands.peak_displacement, exact, tolerance,
                               terms});
  }
  return findings;
}

/// Speed at the end of a half-sine pulse and the distance over g, of a block.
struct HalfSine {
  double speed, distance;  // over g [s], [s2]
  double start;            // [s]

  HalfSine(double mu, double a, double T) {
    const double w = std::numbers::pi / T;
    start = std::asin(mu / a) / w;
    const double left = T - start;
    speed = a / w * (std::cos(w * start) + 1) - mu * left;
    distance = a / w * left * std::cos(w * start) + a / (w * w) * std::sin(w * start) -
               mu * left * left / 2 + speed * speed / (2 * mu);
  }
};

Findings half_sine(const Pulse& p, const Runner& runner) {
  constexpr double kStep = 0.001;
  Findings findings;
  const Slider slider = make_slider(p.rolls != 0, p.friction);
  const double a = p.amplitude * kG, yield = p.friction * kG, T = p.duration;
  const HalfSine exact(p.friction, p.amplitude, T);
  const FloorMotion floor = scenes::floor_motion(T / 1000, T, Vector3::UnitX(), [&](double t) {
    return a * std::sin(std::numbers::pi * t / T);
  });
  const double slide = exact.speed * kG / yield + T;
  const Response response =
      shake(slider, floor, scenes::run_for(slide + 1, kStep), 0, runner, findings);
  const double distance = slider.scale * kG * exact.distance;
  // Half of what the floor gains in a step at the start, a w dt^2.
  const double started = a * std::numbers::pi / T * kStep * kStep / 2;
  const double sampled = std::pow(std::numbers::pi / 1000, 2) / 12;
  findings.checks.push_back(
      {"displacement left", "m", response.items[0].demands.residual_displacement_x, -distance,
       (started + slider.wind_up) * slide + 4 * sampled * distance + yield * kStep * kStep,
       "start inside a step, a (pi/T) dt^2 / 2, and wind-up, mu g sqrt(M/k), last for the slide; "
       "the sampled sine has (pi/1000)^2 / 12 less area, 4 times that of the distance; "
       "mu g dt^2 at the stop"});
  return findings;
}

bool slides_on(const Pulse& p) {
  return slides(p) && HalfSine(p.friction, p.amplitude, p.duration).speed > 0;
}

struct Published {
  double friction, amplitude, duration, distance;  // [g], [s], over g [s2]
};

Findings published(const Published& p, const Runner&) {
  return {
      {{"formula, distance over g", "s2", HalfSine(p.friction, p.amplitude, p.duration).distance,
        p.distance, 5.1e-8, "the digits of the independent integration"}},
      {}};
}

std::vector<Field<Pulse>> fields(double longest) {
  return {{{"rolls", "0 block, 1 cart", 0, 1, true}, &Pulse::rolls},
          {{"friction", "mu or Cr/R", 0.02, 0.4}, &Pulse::friction},
          {{"amplitude", "g", 0.1, 0.8}, &Pulse::amplitude},
          {{"duration", "s", 0.1, longest}, &Pulse::duration}};
}

}  // namespace

Family rectangular_pulse() {
  return make_family<Pulse>(
      {"rectangular_pulse", "sliding", "Sliding after one rectangular pulse of the floor",
       "D = V^2 / (2 mu g) (1 - mu g / A), V = A t0; a cart: times M / (M + J)",
       "Newmark 1965, Geotechnique 15:139"},
      fields(0.6),
      {{"block", {0, 0.1, 0.5, 0.3}},
       {"block_slippery", {0, 0.03, 0.4, 0.25}},
       {"block_odd_duration", {0, 0.2, 0.35, 0.415}},  // no whole number of steps
       {"block_weak", {0, 0.02, 0.1, 0.5}},
       {"cart", {1, 0.1, 0.5, 0.3}},
       {"cart_slippery", {1, 0.03, 0.4, 0.25}},
       {"cart_odd_duration", {1, 0.2, 0.35, 0.415}},
       {"cart_weak", {1, 0.02, 0.1, 0.5}}},
      rectangular, slides);
}

Family half_sine_pulse() {
  return make_family<Pulse>(
      {"half_sine_pulse", "sliding", "Sliding after one half-sine pulse of the floor",
       "starts at sin(w t1) = mu g / a, has v = a/w (cos(w t1) + 1) - mu g (T - t1) at its end and "
       "slides on for v^2 / (2 mu g); a cart: times M / (M + J)",
       "Newmark 1965, Geotechnique 15:139, integrated"},
      fields(1),
      {{"block", {0, 0.05, 0.5, 0.5}},
       {"block_short", {0, 0.3, 0.8, 0.3}},
       {"block_long", {0, 0.02, 0.2, 1}},
       {"cart", {1, 0.05, 0.5, 0.5}},
       {"cart_short", {1, 0.3, 0.8, 0.3}},
       {"cart_long", {1, 0.02, 0.2, 1}}},
      half_sine, slides_on);
}

Family half_sine_pulse_formula() {
  Family family = make_family<Published>(
      {"half_sine_pulse_formula", "sliding", "The formula of half_sine_pulse gives a known number",
       "as half_sine_pulse", "an independent integration with a high resolution"},
      {{{"friction", "mu", 0, 1}, &Published::friction},
       {{"amplitude", "g", 0, 1}, &Published::amplitude},
       {{"duration", "s", 0, 1}, &Published::duration},
       {{"distance", "s2", 0, 1}, &Published::distance}},
      {{"plain", {0.05, 0.5, 0.5, 0.21478124}}}, published);
  family.drawn = false;
  return family;
}

}  // namespace gurney::verification
