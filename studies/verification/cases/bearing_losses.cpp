#include <cmath>

#include "studies/verification/family.h"
#include "studies/verification/gravity.h"
#include "studies/verification/scenes/scenes.h"

namespace gurney::verification {
namespace {

using namespace scenes;

// A rolling patch under the force f slips by f / (k_t sigma) of its travel s (relaxation), which
// takes f^2 s / (k_t sigma) for each wheel, and so much less goes into the wheels' turning. In a
// coast, f = f_r - J a2 of all wheels together.
struct Soft {
  double stiffness = 1e5, resistance = 0.02, speed = 1, mass = 96.5;  // k_t [N/m], Cr/R, [m/s]
};

Findings relax(const Soft& c, const Runner& runner) {
  constexpr double kDuration = 2;
  Findings findings;
  ItemOptions options;
  options.total_mass = c.mass;
  options.caster.tread.tangential_stiffness = c.stiffness;
  options.caster.tread.rolling_friction_length = c.resistance * options.caster.wheel_radius;
  Scene scene = scene_of(trolley(options));
  scene.items[0].initial.velocity.x() = c.speed;
  scene.items[0].fixture = hold_rotations(false, true, false);
  const Tread& tread = options.caster.tread;
  const double inertia = wheel_inertia_mass(scene.items[0].model);
  const double resistance = c.resistance * c.mass * kG, a2 = resistance / (c.mass + inertia);
  const Response response = runner(findings, scene, {}, run_for(kDuration, 0.001, kDuration));
  const double travel = c.speed * kDuration - a2 * kDuration * kDuration / 2;
  const double force = (resistance - inertia * a2) / 4;
  const double slip = force / (c.stiffness * tread.relaxation_length);
  const double start = tread.relaxation_length / travel;
  const double expected = 4 * force * slip * travel;
  findings.checks.push_back({"relaxation loss", "J", response.items[0].energy.relaxation_loss,
                             expected, 2 * (start + slip) * expected,
                             "2 (sigma / s + slip) of it: the start, where the force builds up "
                             "over a travel of sigma, and slip^2 are left out"});
  // While the patch winds up, x1 = f / (n k_t 10 / 11), the wheels do not turn; nor do they by the
  // slip.
  const double turning = resistance * travel * (1 - slip);
  findings.checks.push_back(
      {"rolling loss", "J", response.items[0].energy.rolling_loss, turning,
       resistance *
           (travel * slip * (2 * start + slip) + 2 * resistance / (4 * c.stiffness * 10 / 11)),
       "f_r s slip (2 sigma / s + slip), and 2 f_r / k of path while the treads wind up"});
  return findings;
}

/// Still in motion at the end.
bool goes_on(const Soft& c) { return c.speed > 1.5 * 2 * c.resistance * kG; }

// A caster towed from a heading psi0 turns into line; its swivel friction takes c |psi0 - psi|.
struct Swivel {
  double heading, friction = 0.05, mass = 25, speed = 0.3;  // [rad], [N m], [kg], [m/s]
};

Findings turn(const Swivel& c, const Runner& runner) {
  Findings findings;
  Caster caster = rubber_caster();
  caster.swivel.coulomb = c.friction;
  caster.heading = c.heading;
  Scene scene = scene_of(single_caster(c.mass, caster));
  scene.items[0].fixture = tow(c.speed);
  const Response response = runner(findings, scene, {}, run_for(0.6 / c.speed, 0.001, 0.001));
  double turned = 0, last = c.heading;
  int turns = 1;
  double direction = 0;
  for (const Sample& s : response.items[0].history) {
    const double change = s.wheels[0].swivel_angle - last;
    if (change * direction < 0) ++turns;
    if (change != 0) direction = change;
    turned += std::abs(change);
    last = s.wheels[0].swivel_angle;
  }
  // A stuck bearing is a spring of 10 k_t R^2.
  const double spring = 10 * caster.tread.tangential_stiffness * std::pow(caster.wheel_radius, 2);
  findings.checks.push_back(
      {"swivel loss", "J", response.items[0].energy.swivel_loss, c.friction * turned,
       2 * c.friction * c.friction / spring * turns + 1e-3 * 1e-3 * c.friction,
       "elastic wind-up of the stuck bearing, 2 c^2 / (10 k_t R^2) for each "
       "of its turns; 1e-6 rad"});
  return findings;
}

}  // namespace

Family relaxation() {
  return make_family<Soft>(
      {"relaxation", "conservation", "A rolling soft tread forgets its deflection and loses energy",
       "W = f^2 s / (k_t sigma) for each wheel, f = (f_r - J a2) / n",
       "first-order relaxation of a tyre, Pacejka, Tyre and Vehicle Dynamics"},
      {{{"stiffness", "N/m", 5e4, 1e6}, &Soft::stiffness},
       {{"resistance", "Cr/R", 0.005, 0.03}, &Soft::resistance},
       {{"speed", "m/s", 0.5, 2}, &Soft::speed},
       {{"mass", "kg", 60, 250}, &Soft::mass}},
      {{"plain", {}}}, relax, goes_on);
}

Family swivel_friction() {
  return make_family<Swivel>(
      {"swivel_friction", "conservation", "A towed caster turns against the friction of its swivel",
       "W = c times the angle turned", "work of a constant torque"},
      {{{"heading", "rad", 0.3, 2.8}, &Swivel::heading},
       {{"friction", "N m", 0.01, 0.1}, &Swivel::friction},
       {{"mass", "kg", 15, 60}, &Swivel::mass},
       {{"speed", "m/s", 0.1, 0.5}, &Swivel::speed}},
      {{"ahead", {0.5}}, {"crosswise", {1.5}}, {"behind", {2.5}}}, turn);
}

}  // namespace gurney::verification
