#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "studies/verification/family.h"
#include "studies/verification/gravity.h"
#include "studies/verification/scenes/scenes.h"

// Rolling resistance holds like dry friction: at rest the trolley carries up to f_r = (Cr / R) N
// without creep.
namespace gurney::verification {
namespace {

using namespace scenes;

constexpr double kShare = 0.9;  // slope over Cr / R

struct Slope {
  double slope, down = 0;  // tan(angle); 1: casters trail as it rolls down
  double odd = 0;          // 1: casters at odd headings, with friction on the swivels
  double mass = 96.5;
};

Findings hold(const Slope& c, const Runner& runner) {
  Findings findings;
  ItemOptions options;
  options.total_mass = c.mass;
  Caster& caster = options.caster;
  caster.tread.rolling_friction_length = c.slope / kShare * caster.wheel_radius;
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
  if (c.odd != 0) return findings;  // it moves a little first, until its casters hold it
  findings.checks.push_back({"peak displacement in 60 s", "m", item.demands.peak_displacement, 0,
                             1e-9, "a run starts from equilibrium: 1e-9 m"});
  findings.checks.push_back({"rolling loss", "J", item.energy.rolling_loss, 0, 0, "nothing rolls"});
  int sticking = 0;
  for (int i = 0; i < 4; ++i) sticking += item.history.back().wheels[i].mode == WheelMode::kSticks;
  findings.checks.push_back({"wheels that stick", "", sticking * 1.0, 4, 0, "all of them"});
  return findings;
}

// Below the threshold (Cr / R) g a harmonic floor only sways the trolley on its treads; an envelope
// keeps them from ringing. X is the path of the axles, P the pitch on the treads about them, d the
// height of the centre of mass over the axles:
//
//     (k - M w^2) X - M d w^2 P = M A,   -M d w^2 X + (k_p - (I + M d^2) w^2) P = M d A
//
// with k = n k_t 10/11 and k_p = n k_n b^2; the item's origin, on the floor, goes X - R P.
struct Harmonic {
  double amplitude, frequency;  // [g], [Hz]
  double stiffness = 1e5, mass = 96.5;
};

Response shaken(const Harmonic& c, double resistance, const Runner& runner, Findings& findings) {
  ItemOptions options;
  options.total_mass = c.mass;
  options.caster.tread.tangential_stiffness = c.stiffness;
  options.caster.tread.rolling_friction_length = resistance * options.caster.wheel_radius;
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

struct Sway {
  double origin, pitch;  // [m], [rad]
};

Sway steady(const Harmonic& c) {
  ItemOptions options;
  options.total_mass = c.mass;
  const MassProperties whole = whole_item(trolley(options));
  const double w2 = std::pow(2 * std::numbers::pi * c.frequency, 2), R = Caster().wheel_radius;
  const double M = c.mass, d = whole.center_of_mass.z() - R;
  Matrix2 matrix;
  matrix << 4 * c.stiffness * 10 / 11 - M * w2, -M * d * w2, -M * d * w2,
      4 * Tread().normal_stiffness * kBase * kBase - (whole.inertia(1, 1) + M * d * d) * w2;
  const Vector2 found = matrix.inverse() * (M * c.amplitude * kG * Vector2(1, d));
  return {found[0] - R * found[1], found[1]};
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
  const double w = 2 * std::numbers::pi * c.frequency, k = 4 * c.stiffness * 10 / 11;
  const double omega = std::sqrt(k / c.mass);
  const Sway sway = steady(c);
  // A change of the envelope's rate, 1/5 per second, rings with 1 / (5 omega).
  const double share = 1 / (5 * omega) + std::pow(0.004 * w, 2) / 8;
  const double leaning = c.mass * kG * ItemOptions().chassis_center.z() /
                         (4 * Tread().normal_stiffness * kBase * kBase);
  findings.checks.push_back(
      {"peak sway", "m", item.demands.peak_displacement, sway.origin,
       share * sway.origin +
           (leaning + std::pow(Caster().trail / kBase, 2)) * sway.pitch * Caster().wheel_radius,
       "1 / (5 s omega) of it, with which the envelope's kinks ring, and (w dt)^2 / 8 for samples "
       "of the floor; of R P the share M g h / k_p by which the weight helps to pitch, and (L/b)^2 "
       "for wheels a trail behind"});
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
       "(k - M w^2) X - M d w^2 P = M A, -M d w^2 X + (k_p - (I + M d^2) w^2) P = M d A, k = n k_t "
       "10/11, while A < (Cr/R) g",
       "Newton's law for two oscillators"},
      {{{"amplitude", "g", 0.003, 0.01}, &Harmonic::amplitude},
       {{"frequency", "Hz", 0.3, 1}, &Harmonic::frequency},
       {{"stiffness", "N/m", 8e4, 4e5}, &Harmonic::stiffness},
       {{"mass", "kg", 60, 150}, &Harmonic::mass}},
      {{"half_Hz", {0.005, 0.5}}, {"1_Hz", {0.005, 1}}}, sway_below, holds_on_every_wheel);
}

}  // namespace gurney::verification
