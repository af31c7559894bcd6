#include <cmath>
#include <limits>
#include <numbers>

#include "studies/verification/cases.h"
#include "studies/verification/cases/sliding_block.h"
#include "studies/verification/scenes/blocks.h"

// A block slides without friction into the end of its cord, which runs along x through its centre.
namespace gurney::verification {
namespace {

constexpr double kSlack = 0.2, kNever = std::numeric_limits<double>::infinity();  // [m], [N]

struct Cord {
  double stiffness, damping = 0, speed = 0.6, mass = 50;  // [N/m], of critical, [m/s], [kg]
  double omega() const { return std::sqrt(stiffness / mass); }
};

Scene tied(const Cord& c, double strength) {
  Scene scene = blocks::block(c.mass, {0.4, 0.4, 0.5}, {.friction = 0});
  scene.items[0].initial.velocity = {c.speed, 0, 0};
  Tether cord{.name = "cord", .point = {-0.2, 0, 0.25}, .anchor = {-1.2, 0, 0.25}};
  cord.slack_length = 1 + kSlack;
  cord.stiffness = c.stiffness;
  cord.damping = 2 * c.damping * c.stiffness / c.omega();
  cord.strength = strength;
  scene.tethers = {cord};
  return scene;
}

/// The share of an oscillation that 1/100 of a radian in each step misses, and the first touch,
/// inside a step that no event ends.
constexpr double kStepPhase = 0.01;

Findings throw_back(const Cord& c, const Runner& runner) {
  Findings findings;
  const double v = c.speed, h = kStepPhase / c.omega();
  const CappedDamping exact(c.omega(), c.damping);
  const double taut = kSlack / v, m = c.mass;
  const Response response =
      runner(findings, tied(c, kNever), {}, blocks::run_for(taut + 1.5 * exact.duration, h, h));
  const TetherOutcome& cord = response.tethers.at(0);
  // With damping the force has kinks, which cost a step its second order: phi^2 / 2 each, twice.
  const double kinks = c.damping > 0 ? kStepPhase * kStepPhase : 0;
  const double error = kStepPhase * kStepPhase + kinks;
  const char* const terms =
      "phi^2 of it, phi = omega dt = 0.01: a second-order method whose steps the cord gets taut "
      "and slack in, and as much for the kinks of the force with damping";
  const double after = response.items[0].history.back().velocity.x();
  const double rebound = exact.restitution * v, force = exact.peak * v * m;
  // Where the cap ends in a peak (zeta > 1/sqrt(8)) the force rises with omega / (2 zeta) of it.
  const bool pointed = 8 * c.damping * c.damping > 1;
  auto& checks = findings.checks;
  checks.push_back({"speed back", "m/s", -after, rebound, error * v, terms});
  checks.push_back({"tension", "N", cord.peak_tension, force,
                    (error + (pointed ? kStepPhase / (2 * c.damping) : 0)) * force,
                    std::string(terms) + "; phi / (2 zeta) where the peak is a point"});
  checks.push_back({"time at which it gets taut", "s", cord.time_taut, taut, h, "one step"});
  checks.push_back({"cords that broke", "", cord.time_broken < 0 ? 0. : 1., 0, 0, "it holds"});
  const double energy = 0.5 * m * v * v;
  checks.push_back({"energy that the damper took", "J", response.items[0].energy.damper_loss,
                    energy * (1 - exact.restitution * exact.restitution), 2 * error * energy,
                    "twice that of the speed"});
  checks.push_back({"energy balance error", "", response.quality.energy_closure, 0, error, terms});
  return findings;
}

struct Weak {
  double stiffness, share, speed = 0.6, mass = 50;  // strength over the largest tension
};

/// It breaks where k s = strength, with m v'^2 = m v^2 - strength^2 / k left. The step that ends
/// beyond the strength breaks it: up to k v h more than the strength.
Findings break_it(const Weak& c, const Runner& runner) {
  Findings findings;
  const Cord cord{c.stiffness, 0, c.speed, c.mass};
  const double k = c.stiffness, v = c.speed, m = c.mass, h = kStepPhase / cord.omega();
  const double strength = c.share * v * std::sqrt(k * m);
  const double breaks = kSlack / v + std::asin(c.share) / cord.omega();
  const Response response =
      runner(findings, tied(cord, strength), {}, blocks::run_for(breaks + 0.2 / v, h, h));
  const TetherOutcome& outcome = response.tethers.at(0);
  const auto left = [&](double tension) {
    return std::sqrt(std::max(0.0, v * v - tension * tension / (k * m)));
  };
  const double most = strength + k * v * h;
  auto& checks = findings.checks;
  checks.push_back({"time at which it breaks", "s", outcome.time_broken, breaks + 0.5 * h, h,
                    "a step: it breaks at the end of one; half of one for the touch"});
  checks.push_back({"tension at which it breaks", "N", outcome.peak_tension,
                    0.5 * (strength + most), 0.5 * (most - strength),
                    "between the strength and k v dt more"});
  checks.push_back({"speed that is left", "m/s", response.items[0].history.back().velocity.x(),
                    0.5 * (left(strength) + left(most)),
                    0.5 * (left(strength) - left(most)) + kStepPhase * kStepPhase * v,
                    "that of tensions between the strength and k v dt more; (omega dt)^2 of it"});
  checks.push_back({"energy balance error", "", response.quality.energy_closure, 0,
                    kStepPhase * kStepPhase, "(omega dt)^2 of a method of second order"});
  return findings;
}

}  // namespace

Family cord() {
  return make_family<Cord>(
      {"cord", "impacts", "A block slides into the end of its cord and is thrown back",
       "undamped: taut for pi sqrt(m/k), T = v sqrt(k m), all of the speed back; damped: T = k s + "
       "min(max(c s', -k s), k s)",
       "Newton's law for an oscillator"},
      {{{"stiffness", "N/m", 200, 5e4}, &Cord::stiffness},
       {{"damping", "of critical", 0, 0.6}, &Cord::damping},
       {{"speed", "m/s", 0.1, 2}, &Cord::speed},
       {{"mass", "kg", 10, 200}, &Cord::mass}},
      {{"soft", {500}}, {"stiff", {5000}}, {"damped", {2000, 0.158}}}, throw_back);
}

Family weak_cord() {
  return make_family<Weak>(
      {"weak_cord", "impacts", "A cord breaks at its strength and the block goes on",
       "m v'^2 = m v^2 - T^2 / k, at asin(T / (v sqrt(k m))) sqrt(m / k) after it got taut",
       "energy of an oscillator"},
      {{{"stiffness", "N/m", 200, 5e4}, &Weak::stiffness},
       {{"share", "T over v sqrt(k m)", 0.1, 0.95}, &Weak::share},
       {{"speed", "m/s", 0.1, 2}, &Weak::speed},
       {{"mass", "kg", 10, 200}, &Weak::mass}},
      {{"half", {5000, 0.5}}, {"early", {5000, 0.2}}, {"late", {1000, 0.9}}}, break_it);
}

}  // namespace gurney::verification
