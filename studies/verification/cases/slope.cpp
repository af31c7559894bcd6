#include <cmath>
#include <numbers>

#include "studies/verification/family.h"
#include "studies/verification/gravity.h"
#include "studies/verification/scenes/scenes.h"
#include "studies/verification/scenes/wind_up.h"

namespace gurney::verification {
namespace {

using namespace scenes;

struct Ramp {
  double slope, share;  // tan(angle), and Cr / R over it
  double mass = 96.5, wheel_mass = 0.25;
};

/// Casters trail as the trolley rolls down; x points uphill.
Scene on_slope(const Ramp& c, double slope, double resistance, bool stiff) {
  ItemOptions options;
  options.total_mass = c.mass;
  options.caster.wheel_mass = c.wheel_mass;
  options.caster.tread.rolling_friction_length = resistance * options.caster.wheel_radius;
  if (stiff) stiffen(options.caster.tread);
  set_wheel_inertia(options.caster);
  options.headings.assign(4, std::numbers::pi);
  Scene scene = scene_of(trolley(options));
  scene.slope = slope;
  return scene;
}

// A run starts from equilibrium, so the trolley winds up its treads from rest (wind_up.h).
void accelerates(const Ramp& c, const Runner& runner, Findings& findings) {
  constexpr double kDuration = 4;
  Scene scene = on_slope(c, c.slope, c.share * c.slope, true);
  const EquipmentModel& item = scene.items[0].model;
  const double mass = total_mass(item), inertia = mass + wheel_inertia_mass(item);
  const double pull = mass * kG * std::sin(std::atan(c.slope)), resistance = c.share * pull;
  const double a = (pull - resistance) / inertia;
  scene.items[0].fixture = hold_rotations(false, true, false);
  const Response response = runner(findings, scene, {}, run_for(kDuration, 0.004, 0.02));
  const double k = 4 * item.casters[0].tread.tangential_stiffness * 10 / 11;
  const double speed = wind_up_speed(pull, resistance, k, mass);
  const char* const terms =
      "wind-up of the treads, (sqrt(f (2 F - f)) - (F - f) acos(1 - f / F)) / sqrt(k M) with "
      "F = M g sin; residual of the solve, 1e-9 g t";
  Track displacement("displacement", "m", std::string("times the time: ") + terms);
  Track velocity("velocity", "m/s", terms);
  for (const Sample& s : response.items[0].history) {
    const double tolerance = speed + 1e-9 * kG * s.time, t = s.time;
    displacement.add(t, s.displacement.x(), -a * t * t / 2, tolerance * t);
    velocity.add(t, s.velocity.x(), -a * t, tolerance);
  }
  displacement.report(findings);
  velocity.report(findings);
}

// What holds on soft treads is stuck rolling resistance: it neither creeps nor rolls.
void holds(const Ramp& c, const Runner& runner, Findings& findings) {
  constexpr double kRolled = 1e-3, kDuration = 10;  // [m], [s]
  const double resistance = c.slope / 2;
  const double threshold = locate(0.8, 1.2, 0.004, [&](double share) {
    return runner(findings, on_slope(c, share * resistance, resistance, false), {},
                  run_for(kDuration, 0.004))
               .items[0]
               .demands.residual_displacement_x < -kRolled;
  });
  findings.checks.push_back(
      {"slope from which it rolls, over Cr/R", "", threshold, 1,
       0.002 + 2 * kRolled / (kG * kDuration * kDuration * resistance),
       "half of the last bracket, 0.002, and the slope that needs 10 s to roll 1 mm, "
       "2 x / (g t^2 Cr/R)"});
}

Findings ramp(const Ramp& c, const Runner& runner) {
  Findings findings;
  accelerates(c, runner, findings);
  holds(c, runner, findings);
  return findings;
}

}  // namespace

Family slope() {
  return make_family<Ramp>(
      {"slope", "pulling", "A trolley on a slope: it rests below a threshold and rolls above it",
       "rests while tan(a) < Cr/R, else a = M g sin(a) (1 - Cr/R / tan(a)) / (M + J)",
       "Newton's law; rolling resistance as dry friction"},
      {{{"slope", "tan", 0.004, 0.08}, &Ramp::slope},
       {{"share", "Cr/R over tan", 0, 0.8}, &Ramp::share},
       {{"mass", "kg", 40, 250}, &Ramp::mass},
       {{"wheel_mass", "kg", 0.1, 2}, &Ramp::wheel_mass}},
      {{"gentle_free", {0.005, 0}},
       {"gentle", {0.005, 0.3}},
       {"gentle_half", {0.005, 0.5}},
       {"free", {0.01, 0}},
       {"plain", {0.01, 0.3}},
       {"half", {0.01, 0.5}},
       {"steep_free", {0.03, 0}},
       {"steep", {0.03, 0.3}},
       {"steep_half", {0.03, 0.5}}},
      ramp);
}

}  // namespace gurney::verification
