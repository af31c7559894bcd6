#include "studies/verification/scenes/wind_up.h"

#include <cmath>

#include "studies/verification/family.h"
#include "studies/verification/gravity.h"
#include "studies/verification/scenes/scenes.h"

// A wheel does not resist in full at once: its tread and the stuck rolling resistance wind up. They
// are springs in series, k_t and 10 k_t at the rim (engine/contact/tread_law.cpp), so with
// k = n k_t 10 / 11 and the wheels turning by 1/11 of the motion, the trolley is an oscillator
// until the resistance is reached at x1 = f / k, and accelerates uniformly from x1, v1 on.
namespace gurney::verification {
namespace {

using namespace scenes;

struct Soft {
  double force, duration;    // [N], [s]
  double stiffness = 1e5;    // k_t [N/m]
  double resistance = 0.02;  // Cr / R
  double mass = 96.5;        // [kg]
};

Findings pull(const Soft& c, const Runner& runner) {
  Findings findings;
  ItemOptions options;
  options.total_mass = c.mass;
  options.caster.tread.tangential_stiffness = c.stiffness;
  options.caster.tread.rolling_friction_length = c.resistance * options.caster.wheel_radius;
  Scene scene = scene_of(trolley(options));
  const Tread& tread = scene.items[0].model.casters[0].tread;
  scene.items[0].fixture = hold_rotations(false, true, false);
  scene.items[0].loads = {constant_force(c.force, c.duration, {0, 0, 0.6})};

  const double inertia = wheel_inertia_mass(scene.items[0].model);
  const double f = c.resistance * c.mass * kG, k = 4 * c.stiffness * 10 / 11;
  const double x1 = f / k, t1 = std::acos(1 - f / c.force) / std::sqrt(k / c.mass);
  const double v1 = std::sqrt(f * (2 * c.force - f) / (k * c.mass));
  const double a1 = (c.force - f) / (c.mass + inertia), t = c.duration - t1;

  const Response response = runner(findings, scene, {}, run_for(c.duration, 0.001, 0.01));
  // Not in the formula: the damping of the patch, and the wheels that spin up from 1/11 to 1.
  const double missing =
      2.0 / 3 * 4 * tread.tangential_damping * x1 / c.mass + 10.0 / 11 * inertia / c.mass * v1;
  const Sample& end = response.items[0].history.back();
  const char* const terms =
      "1.5 times what the formula leaves out: damping of the patch, (2/3) n c_t x1 / M, and the "
      "wheels that spin up, (10/11) J/M v1";
  findings.checks.push_back({"velocity at the end of the pull", "m/s", end.velocity.x(),
                             v1 + a1 * t, 1.5 * missing, terms});
  findings.checks.push_back({"displacement at the end of the pull", "m", end.displacement.x(),
                             x1 + v1 * t + a1 * t * t / 2, 1.5 * missing * c.duration,
                             std::string("times the duration: ") + terms});
  findings.checks.push_back(
      {"speed that winding up adds", "m/s", end.velocity.x() - a1 * c.duration,
       wind_up_speed(c.force, f, k, c.mass + inertia), 1.5 * missing + inertia / c.mass * v1,
       std::string(terms) + "; J/M v1 for the mass that starts"});
  return findings;
}

/// The wind-up is over before the pull is.
bool winds_up(const Soft& c) { return c.force > 1.1 * c.resistance * c.mass * kG; }

}  // namespace

Family wind_up() {
  return make_family<Soft>(
      {"wind_up", "pulling", "A trolley on soft treads: they wind up before they resist",
       "x = F/k (1 - cos(w t)) until x1 = f/k, w^2 = k/M; v1^2 = f (2 F - f) / (k M); then a1",
       "Newton's law for an oscillator, then for cart and wheels"},
      {{{"force", "N", 20, 150}, &Soft::force},
       {{"duration", "s", 0.5, 3}, &Soft::duration},
       {{"stiffness", "N/m", 5e4, 5e5}, &Soft::stiffness},
       {{"resistance", "Cr/R", 0.005, 0.03}, &Soft::resistance},
       {{"mass", "kg", 60, 250}, &Soft::mass}},
      {{"weak", {30, 3}}, {"plain", {40, 2.25}}, {"strong", {80, 1.125}}}, pull, winds_up);
}

}  // namespace gurney::verification
