#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "engine/base/units.h"
#include "studies/verification/family.h"
#include "studies/verification/scenes/scenes.h"

// Rolling resistance holds like dry friction: at rest the trolley carries up to f_r = (Cr / R) N
// without creep.
namespace gurney::verification {
namespace {

using namespace scenes;

constexpr double kG = kStandardGravity;

constexpr double kShare = 0.9;  // slope over Cr / R

struct Slope {
  double slope, down = 0;  // tan(angle); 1: casters trail as it rolls down
  double odd = 0;          // 1: casters at odd headings, with friction on the swivels
  double mass = 96.5;
};

/// How far casters at odd headings let the trolley go before their wheels hold it [m].
///
/// A wheel stands at L u from its mount. Carried by D along a unit vector e it rolls by
/// D + L e.(u - u0) or more, whatever its path. Of the slope's work M g sin(a) D e_down rolling
/// takes (Cr/R) N times that, so with s = 0.9 Cr/R and equal loads
///
///     D (1 - 0.9 e_down) <= L e.mean(u0 - u)
///
/// A mean wheel that moves by L, and the height of the centre of mass, load one wheel by
/// L/a + L/b + h s/a more than the mean (a, b: half of wheelbase and track); a yaw moves the mean
/// mount by L |yaw| at most.
/// @param swing  bound of e.mean(u0 - u), with the yaw
double farthest(const ItemOptions& options, double slope, double swing) {
  const double trail = options.caster.trail;
  const double load = 1 + trail / options.half_wheelbase + trail / options.half_track +
                      options.chassis_center.z() * slope / options.half_wheelbase;
  return trail * load * swing / (1 - kShare);
}

/// It comes to stand no further away than the trails let it.
void odd_way(const ItemOptions& options, const ItemResponse& item, double slope,
             Findings& findings) {
  const Sample& end = item.history.back();
  const double yaw = item.demands.peak_yaw;
  double swing = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto from_mount = [](double heading) {
      return Vector2(-std::cos(heading), -std::sin(heading));
    };
    const Vector2 u0 = from_mount(options.headings[i]);
    swing += (from_mount(end.wheels[i].swivel_angle + end.yaw) - u0).norm() / 4;
  }
  const std::string loads =
      " (1 + L/a + L/b + h s/a): what trails swing is not rolled, and "
      "rolling takes 1 / 0.9 of the slope's work";
  findings.checks.push_back({"way that odd casters let it go", "m",
                             item.demands.residual_displacement, 0,
                             farthest(options, slope, swing + yaw),
                             "10 L (mean|u - u0| + |yaw|)" + loads +
                                 ", u from mounts to wheels, at the end and the start"});
}

Findings hold(const Slope& c, const Runner& runner) {
  Findings findings;
  ItemOptions options;
  options.total_mass = c.mass;
  Caster& caster = options.caster;
  caster.tread.rolling_resistance = c.slope / kShare * caster.wheel_radius;
  options.headings.assign(4, c.down * std::numbers::pi);
  if (c.odd != 0) {
    options.headings = {0.3, 1.6, 2.8, 5.2};
    caster.swivel.coulomb = 0.03;
  }
  Scene scene = scene_of(trolley(options));
  scene.slope = c.slope;
  const Response response = runner(findings, scene, {}, run_for(60, 0.004, 30));
  const ItemResponse& item = response.items[0];
  const double crept = (item.history[2].displacement - item.history[1].displacement).norm();
  // The residual of the solve, 1e-9 M g, on springs.
  const double residual = 1e-9 * c.mass * kG / (4 * caster.tread.tangential_stiffness);
  findings.checks.push_back({"creep from 30 s to 60 s", "m", crept, 0, 1e-9 + 1000 * residual,
                             "1e-9 m, and a thousand times 1e-9 M g on the springs of the treads: "
                             "no step's residual adds to the last"});
  if (c.odd != 0) {
    odd_way(options, item, c.slope, findings);
    return findings;
  }
  findings.checks.push_back({"peak displacement in 60 s", "m", item.demands.peak_displacement, 0,
                             1e-9, "a run starts from equilibrium: 1e-9 m"});
  findings.checks.push_back({"rolling loss", "J", item.energy.rolling_loss, 0, 0, "nothing rolls"});
  int sticking = 0;
  for (int i = 0; i < 4; ++i) sticking += item.history.back().wheels[i].mode == WheelMode::kSticks;
  findings.checks.push_back({"wheels that stick", "", sticking * 1.0, 4, 0, "all of them"});
  return findings;
}

// Below the threshold (Cr / R) g a harmonic floor only sways the trolley on its treads, x = A / w^2
// with w^2 = k / M, k = n k_t 10 / 11; an envelope keeps the treads from ringing.
struct Harmonic {
  double amplitude, frequency;  // [g], [Hz]
  double stiffness = 1e5, mass = 96.5;
};

Response shaken(const Harmonic& c, double resistance, const Runner& runner, Findings& findings) {
  ItemOptions options;
  options.total_mass = c.mass;
  options.caster.tread.tangential_stiffness = c.stiffness;
  options.caster.tread.rolling_resistance = resistance * options.caster.wheel_radius;
  Scene scene = scene_of(trolley(options));
  const FloorMotion floor = floor_motion(0.004, 60, Vector3::UnitX(), [&](double t) {
    return c.amplitude * kG * std::min({1.0, t / 5, (60 - t) / 5}) *
           std::sin(2 * std::numbers::pi * c.frequency * t);
  });
  return runner(findings, scene, floor, run_for(65, 0.004, 0.05));
}

constexpr double kBase = 0.49;  // half of the wheelbase [m]

/// (w / w_t)^2 of the sway, that of pitching on the treads included.
double quickness(const Harmonic& c) {
  const double k = 4 * c.stiffness * 10 / 11, h = ItemOptions().chassis_center.z();
  return std::pow(2 * std::numbers::pi * c.frequency, 2) * c.mass *
         (1 / k + h * h / (4 * Tread().normal_stiffness * kBase * kBase));
}

/// No wheel rolls by itself: the one with the least load, on a base a trail behind the centre of
/// mass, carries its share of 0.9 of the threshold.
bool holds_on_every_wheel(const Harmonic& c) {
  const double h = ItemOptions().chassis_center.z();
  return 0.9 * (1 + quickness(c)) < 1 - (Caster().trail + c.amplitude * h) / kBase;
}

Findings sway_below(const Harmonic& c, const Runner& runner) {
  Findings findings;
  const Response response = shaken(c, c.amplitude / 0.9, runner, findings);
  const ItemResponse& item = response.items[0];
  // The item's origin is on the floor; the item pitches on its treads about wheels that stick.
  const double h = ItemOptions().chassis_center.z();
  const double static_sway = c.amplitude * kG * c.mass / (4 * c.stiffness * 10 / 11);
  const double pitch =
      c.amplitude * kG * c.mass * h / (4 * Tread().normal_stiffness * kBase * kBase);
  findings.checks.push_back({"peak sway", "m", item.demands.peak_displacement, static_sway,
                             2 * quickness(c) * static_sway + pitch * 0.05 + 0.02 * static_sway,
                             "inertia of the sway itself, 2 (w/w_t)^2 of it; pitch on the treads, "
                             "M a h / k_p, at the height of the axles; 2 % for the envelope"});
  findings.checks.push_back(
      {"rolling loss", "J", item.energy.rolling_loss, 0, 1e-15, "nothing rolls: rounding"});
  findings.checks.push_back({"displacement left", "m", item.demands.residual_displacement, 0, 1e-8,
                             "swung out, no creep in 60 s"});
  const double moved = shaken(c, c.amplitude / 1.1, runner, findings).items[0].energy.rolling_loss;
  findings.checks.push_back({"rolls at 1.1 of the threshold (1 yes)", "", moved > 0 ? 1.0 : 0.0, 1,
                             0, "it loses energy by rolling"});
  return findings;
}

}  // namespace

Family hold() {
  return make_family<Slope>(
      {"hold", "standing", "A trolley rests for a minute on 0.9 of the slope from which it rolls",
       "x = 0 while tan(a) < Cr/R", "rolling resistance as dry friction"},
      {{{"slope", "tan", 0.003, 0.05}, &Slope::slope},
       {{"down", "1 casters trail downhill", 0, 1, true}, &Slope::down},
       {{"odd", "1 odd headings", 0, 1, true}, &Slope::odd},
       {{"mass", "kg", 40, 250}, &Slope::mass}},
      {{"gentle_up", {0.005}},
       {"gentle_down", {0.005, 1}},
       {"gentle_odd", {0.005, 0, 1}},
       {"plain_up", {0.01}},
       {"plain_down", {0.01, 1}},
       {"plain_odd", {0.01, 0, 1}},
       {"steep_up", {0.03}},
       {"steep_down", {0.03, 1}},
       {"steep_odd", {0.03, 0, 1}}},
      hold);
}

Family sway() {
  return make_family<Harmonic>(
      {"sway", "standing",
       "Below its threshold a shaken trolley sways on its treads and goes nowhere",
       "x = A M / k, k = n k_t 10/11, while A < (Cr/R) g", "statics of springs in series"},
      {{{"amplitude", "g", 0.003, 0.01}, &Harmonic::amplitude},
       {{"frequency", "Hz", 0.3, 1}, &Harmonic::frequency},
       {{"stiffness", "N/m", 8e4, 4e5}, &Harmonic::stiffness},
       {{"mass", "kg", 60, 150}, &Harmonic::mass}},
      {{"half_Hz", {0.005, 0.5}}, {"1_Hz", {0.005, 1}}}, sway_below, holds_on_every_wheel);
}

}  // namespace gurney::verification
