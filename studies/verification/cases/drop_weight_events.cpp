#include <algorithm>
#include <cmath>
#include <limits>

#include "studies/verification/cases/drop_weight_rig.h"
#include "studies/verification/family.h"
#include "studies/verification/gravity.h"
#include "studies/verification/scenes/wind_up.h"

namespace gurney::verification {
namespace {

using namespace scenes;
using namespace rig;

/// A landing rounded to a step would move the velocity by up to a1 dt.
struct Grid {
  double step;
  double weight = 5, drop = 0.7, resistance = 0.02;
};

Findings land(const Grid& c, const Runner& runner) {
  Findings findings;
  const Rig rig{c.weight, c.drop, c.resistance};
  Scene scene = scene_of(pulled_trolley(rig, 3e8));
  scene.items[0].loads = rigged(rig);
  scene.items[0].fixture = hold_rotations(false, true, false);
  const EquipmentModel& item = scene.items[0].model;
  const Exact e(rig, item);
  const Response response = runner(findings, scene, {}, run_for(kReleaseTime + e.stop + 1, c.step));
  const double M = total_mass(item) + wheel_inertia_mass(item), pull = rig.weight * kG;
  const double k = 4 * item.casters[0].tread.tangential_stiffness * 10 / 11;
  const double reduced = 1 / (1 / M + 1 / rig.weight);
  const double speed =
      wind_up_speed(pull, e.resistance, k, M + rig.weight) +
      (pull - e.tension) / std::sqrt(kCableStiffness * reduced) * rig.weight / (M + rig.weight) +
      e.tension * e.tension / (2 * kCableStiffness * M * e.velocity) +
      1e-9 * kG * (kReleaseTime + e.stop);
  const char* const terms =
      "wind-up of the treads, swing of the cable and what it gives back at the landing, residual, "
      "as in drop_weight";
  findings.checks.push_back(
      {"distance", "m", response.items[0].demands.residual_displacement_x, e.distance,
       speed * e.stop + 2 * pull / kCableStiffness + e.a2 * c.step * c.step,
       std::string("the tolerance of the speed times the time; stretch of cable and blocks, "
                   "2 m_d g / k; a2 dt^2 at the stop: ") +
           terms});
  findings.checks.push_back(
      {"peak velocity", "m/s", response.items[0].demands.peak_velocity, e.velocity, speed, terms});
  return findings;
}

/// All wheels are locked, so the item slides and brakes at mu g.
struct Slack {
  double pulley_inertia;
  double speed = 0.8, friction = 0.3, weight = 5, mass = 96.5;
};

double free_fall(const Slack& c) {
  const double radius = DropWeight().pulley_radius;
  return c.weight * kG / (c.weight + c.pulley_inertia / (radius * radius));
}

double time_taut(const Slack& c) { return 2 * c.speed / (free_fall(c) + c.friction * kG); }

Findings run_ahead(const Slack& c, const Runner& runner) {
  constexpr double kStep = 0.001;
  Findings findings;
  ItemOptions options;
  options.total_mass = c.mass;
  stiffen(options.caster.tread);
  options.caster.tread.static_friction = options.caster.tread.kinetic_friction = c.friction;
  Scene scene = scene_of(locked_block(options));
  scene.items[0].initial.velocity.x() = c.speed;
  scene.items[0].initial.wheels_roll = false;
  scene.items[0].fixture = hold_rotations();
  DropWeight weight;
  weight.point = {0, 0, kPullHeight};
  weight.mass = c.weight;
  weight.drop_height = 2;
  weight.pulley_inertia = c.pulley_inertia;
  scene.items[0].loads = {weight};

  const double braking = c.friction * kG, taut = time_taut(c), pull = c.weight * kG;
  const Response response = runner(findings, scene, {}, run_for(3, kStep, kStep));
  const double wound = braking * c.mass / (4 * options.caster.tread.tangential_stiffness);
  Track displacement("displacement while the cable is slack", "m",
                     "wind-up of the sliding treads, 2 mu M g / (n k_t); the speed that it adds, "
                     "f^2 / (2 k M v0), times the time; residual 1e-9 g t^2");
  Track tension("cable tension while it is slack", "N", "a slack cable carries nothing");
  Track energy("energy of the weight while it falls freely", "J", "1e-9 m_d g");
  double first_taut = 0;
  for (const Sample& s : response.items[0].history) {
    if (s.cable_tension > 0 && first_taut == 0) first_taut = s.time;
    if (s.time > taut - kStep) continue;
    tension.add(s.time, s.cable_tension, 0, 0);
    displacement.add(s.time, s.displacement.x(), c.speed * s.time - braking * s.time * s.time / 2,
                     2 * wound + (wound * braking / (2 * c.speed) + 1e-9 * kG * s.time) * s.time);
    energy.add(s.time, s.energy.weight_energy, 0, 1e-9 * pull);
  }
  displacement.report(findings);
  tension.report(findings);
  energy.report(findings);
  findings.checks.push_back({"time at which the cable is taut", "s", first_taut, taut, 2 * kStep,
                             "one step to tighten, one to report it: 2 dt"});
  // Locked wheels hold the weight: all rests, the cable carries it.
  const Sample& end = response.items[0].history.back();
  const double swings = std::exp(-weight.cable_damping / (2 * c.weight) * (3 - 1.5));
  findings.checks.push_back({"cable tension at rest", "N", end.cable_tension, pull,
                             pull * (swings + 1e-6),
                             "m_d g (exp(-c_c t / (2 m_d)) + 1e-6): the swing that is left"});
  findings.checks.push_back(
      {"velocity at rest", "m/s", end.velocity.x(), 0, 1e-6, "as for the tension"});
  return findings;
}

/// It still slides when the cable tightens, and then holds the weight.
bool holds(const Slack& c) {
  return time_taut(c) < 0.9 * c.speed / (c.friction * kG) && time_taut(c) < 1 &&
         c.weight < 0.5 * c.friction * c.mass;
}

}  // namespace

Family drop_weight_grid() {
  return make_family<Grid>(
      {"drop_weight_landing", "pulling", "A landing does not depend on the grid of steps",
       "as drop_weight", "Newton's law; the landing is an event inside a step"},
      {{{"step", "s", 0.003, 0.006}, &Grid::step},
       {{"weight", "kg", 4, 10}, &Grid::weight},
       {{"drop", "m", 0.3, 1.2}, &Grid::drop},
       {{"resistance", "Cr/R", 0.01, 0.025}, &Grid::resistance}},
      {{"4_ms", {0.004}}, {"4.1_ms", {0.0041}}, {"4.3_ms", {0.0043}}, {"4.7_ms", {0.0047}}}, land);
}

Family drop_weight_slack() {
  return make_family<Slack>(
      {"drop_weight_slack", "pulling", "An item runs ahead of its weight: the cable is slack",
       "taut again after t = 2 v0 / (g' + mu g), g' = m_d g / (m_d + p)", "Newton's law"},
      {{{"pulley_inertia", "kg m2", 0, 0.01}, &Slack::pulley_inertia},
       {{"speed", "m/s", 0.3, 1.5}, &Slack::speed},
       {{"friction", "mu", 0.1, 0.5}, &Slack::friction},
       {{"weight", "kg", 2, 12}, &Slack::weight},
       {{"mass", "kg", 60, 200}, &Slack::mass}},
      {{"light_pulley", {0}}, {"heavy_pulley", {0.01}}}, run_ahead, holds);
}

}  // namespace gurney::verification
