#include <cmath>
#include <limits>

#include "studies/verification/cases/sliding_block.h"
#include "studies/verification/family.h"
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

void throw_back(const Cord& c, Runner& runner) {
  const double v = c.speed, h = kStepPhase / c.omega();
  const CappedDamping exact(c.omega(), c.damping);
  const double taut = kSlack / v, m = c.mass;
  const Response response =
      runner(tied(c, kNever), {}, blocks::run_for(taut + 1.5 * exact.duration, h, h));
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
  runner.check("speed back", "m/s", -after, near_to(rebound, error * v, terms));
  runner.check("tension", "N", cord.peak_tension,
               near_to(force, (error + (pointed ? kStepPhase / (2 * c.damping) : 0)) * force,
                       std::string(terms) + "; phi / (2 zeta) where the peak is a point"));
  runner.check("time at which it gets taut", "s", cord.time_taut, near_to(taut, h, "one step"));
  runner.check("cords that broke", "", cord.time_broken < 0 ? 0. : 1., exactly(0, "it holds"));
  const double energy = 0.5 * m * v * v;
  runner.check("energy that the damper took", "J", response.items[0].energy.damper_loss,
               near_to(energy * (1 - exact.restitution * exact.restitution), 2 * error * energy,
                       "twice that of the speed"));
  runner.check("energy balance error", "", response.quality.energy_closure,
               near_to(0, error, terms));
}

struct Weak {
  double stiffness, share, speed = 0.6, mass = 50;  // strength over the largest tension
};

/// It breaks where k s = strength, with m v'^2 = m v^2 - strength^2 / k left; a step ends there. The cord gets taut
/// inside a step, whose spring force then misses up to k v h for h: (omega h)^2 of the speed, as the method's error.
/// The tension grows with k v sqrt(1 - share^2) when it breaks.
void break_it(const Weak& c, Runner& runner) {
  const Cord cord{c.stiffness, 0, c.speed, c.mass};
  const double v = c.speed, h = kStepPhase / cord.omega(), error = kStepPhase * kStepPhase;
  const double strength = c.share * v * std::sqrt(c.stiffness * c.mass);
  const double breaks = kSlack / v + std::asin(c.share) / cord.omega();
  const double left = std::sqrt(1 - c.share * c.share);  // of the speed
  const Response response =
      runner(tied(cord, strength), {}, blocks::run_for(breaks + 0.2 / v, h, h));
  const TetherOutcome& outcome = response.tethers.at(0);
  runner.check("time at which it breaks", "s", outcome.time_broken,
               near_to(breaks, error / (cord.omega() * left),
                       "(omega dt)^2 of the tension, over its growth"));
  runner.check("tension at which it breaks", "N", outcome.peak_tension,
               near_to(strength, 1e-9 * c.stiffness, "a stretch of 1 nm"));
  runner.check("speed that is left", "m/s", response.items[0].history.back().velocity.x(),
               near_to(left * v, error * v / left, "(omega dt)^2 of the energy"));
  runner.check("energy balance error", "", response.quality.energy_closure,
               near_to(0, error, "(omega dt)^2 of a method of second order"));
}

}  // namespace

Family cord() {
  return make_family<Cord>(
      {"cord", "impacts", "A block slides into the end of its cord and is thrown back",
       "undamped: taut for pi sqrt(m/k), T = v sqrt(k m), all of the speed back; damped: T = k s + "
       "min(max(c s', -k s), k s)",
       "Newton's law for an oscillator"},
      fields(FIELD(Cord, stiffness, "N/m", 200, 5e4), FIELD(Cord, damping, "of critical", 0, 0.6),
             FIELD(Cord, speed, "m/s", 0.1, 2), FIELD(Cord, mass, "kg", 10, 200)),
      cases(at("soft", 500), at("stiff", 5000), at("damped", 2000, 0.158)), throw_back);
}

Family weak_cord() {
  return make_family<Weak>(
      {"weak_cord", "impacts", "A cord breaks at its strength and the block goes on",
       "m v'^2 = m v^2 - T^2 / k, at asin(T / (v sqrt(k m))) sqrt(m / k) after it got taut",
       "energy of an oscillator"},
      fields(FIELD(Weak, stiffness, "N/m", 200, 5e4),
             FIELD(Weak, share, "T over v sqrt(k m)", 0.1, 0.95), FIELD(Weak, speed, "m/s", 0.1, 2),
             FIELD(Weak, mass, "kg", 10, 200)),
      cases(at("half", 5000, 0.5), at("early", 5000, 0.2), at("late", 1000, 0.9)), break_it);
}

}  // namespace gurney::verification
