#include <cmath>

#include "studies/verification/family.h"
#include "studies/verification/gravity.h"
#include "studies/verification/scenes/scenes.h"

// What moves at v0 comes to rest when a force has taken its kinetic energy: the distance gives the
// force, the energy balance shows whose it was.
namespace gurney::verification {
namespace {

using namespace scenes;

struct Coast {
  double resistance, speed = 1;  // Cr / R, or mu, or the brake's torque [N m]; v0 [m/s]
  double mass = 96.5;
};

EquipmentModel stiff_trolley(const Coast& c, double rolling_resistance, double brake) {
  ItemOptions options;
  options.total_mass = c.mass;
  stiffen(options.caster.tread);
  options.caster.tread.rolling_friction_length = rolling_resistance * options.caster.wheel_radius;
  options.caster.brake_torque = brake;
  return trolley(options);
}

Response coast(const EquipmentModel& item, const Vector3& velocity, double step, double duration,
               const Fixture& fixture, const Runner& runner, Findings& findings) {
  Scene scene = scene_of(item);
  scene.items[0].initial.velocity = velocity;
  scene.items[0].initial.wheels_roll = item.casters[0].brake_torque < INFINITY;
  scene.items[0].fixture = fixture;
  return runner(findings, scene, {}, run_for(duration, step, 0.05));
}

/// @param force       that stops it, all wheels [N]
/// @param inertia     M, or M + J
void compare(const Response& response, double loss, const std::string& of, double force,
             double inertia, double speed, double step, Findings& findings) {
  const double a = force / inertia, distance = speed * speed / (2 * a);
  // Treads wind up over f / k, k = 4e9 N/m at least 10/11 of it, and the stop falls inside a step.
  const double wound = 2 * force / (4e9 * 10 / 11), stop = a * step * step;
  const double residual = 1e-9 * kG * speed / a * speed / a;
  const double slip = force / (4 * 1e9 * Tread().relaxation_length);
  const ItemResponse& item = response.items[0];
  const char* const terms =
      "wind-up of the treads, 2 f / k; the stop inside a step, a dt^2; residual 1e-9 g t^2";
  Track velocity("speed", "m/s",
                 "a times the time to wind up, 2 f / (k v0), and a dt at the stop; "
                 "residual 1e-9 g t");
  for (const Sample& s : item.history) {
    const double v = std::max(0.0, speed - a * s.time);
    velocity.add(s.time, s.velocity.head<2>().norm(), v,
                 a * wound / speed + 1e-9 * kG * s.time +
                     std::sqrt(force * force / (4e9 * inertia)) +
                     (v < 2 * a * step ? a * step : 0));
  }
  velocity.report(findings);
  findings.checks.push_back({"distance", "m", item.demands.residual_displacement, distance,
                             wound + stop + residual, terms});
  findings.checks.push_back(
      {of, "J", loss, inertia * speed * speed / 2,
       force * (wound + stop + residual + slip * distance),
       std::string("the force times the tolerance of the distance, and the slip "
                   "of rolling treads, f / (n k_t sigma), times the distance: ") +
           terms});
}

Findings rolls(const Coast& c, const Runner& runner) {
  Findings findings;
  const EquipmentModel item = stiff_trolley(c, c.resistance, 0);
  const double inertia = c.mass + wheel_inertia_mass(item), force = c.resistance * c.mass * kG;
  const double time = c.speed * inertia / force;
  const Response response = coast(item, {c.speed, 0, 0}, 0.004, time + 1,
                                  hold_rotations(false, true, false), runner, findings);
  compare(response, response.items[0].energy.rolling_loss, "rolling loss", force, inertia, c.speed,
          0.004, findings);
  findings.checks.push_back({"sliding loss", "J", response.items[0].energy.sliding_loss, 0, 1e-9,
                             "rolling wheels do not slide: 1e-9 J"});
  return findings;
}

Findings slides(const Coast& c, const Runner& runner) {
  Findings findings;
  ItemOptions options;
  options.total_mass = c.mass;
  stiffen(options.caster.tread);
  options.caster.tread.static_friction = options.caster.tread.kinetic_friction = c.resistance;
  const EquipmentModel item = locked_block(options);
  const double force = c.resistance * c.mass * kG;
  const Response response =
      coast(item, c.speed * Vector3(0.8, 0.6, 0), 0.001, c.speed / (c.resistance * kG) + 1,
            hold_rotations(), runner, findings);
  compare(response, response.items[0].energy.sliding_loss, "sliding loss", force, c.mass, c.speed,
          0.001, findings);
  return findings;
}

Findings brakes(const Coast& c, const Runner& runner) {
  Findings findings;
  const EquipmentModel item = stiff_trolley(c, 0, c.resistance);
  const double inertia = c.mass + wheel_inertia_mass(item);
  const double force = 4 * c.resistance / item.casters[0].wheel_radius;
  const Response response = coast(item, {c.speed, 0, 0}, 0.001, c.speed * inertia / force + 1,
                                  hold_rotations(false, true, false), runner, findings);
  compare(response, response.items[0].energy.axle_loss, "axle loss", force, inertia, c.speed, 0.001,
          findings);
  return findings;
}

/// The wheels roll: the brakes need less than half of mu_s M g.
bool grips(const Coast& c) { return 4 * c.resistance / 0.05 < 0.3 * c.mass * kG; }

/// It rests within 30 s.
bool rests(const Coast& c) { return c.speed / (c.resistance * kG) < 30; }

}  // namespace

Family coasting() {
  return make_family<Coast>(
      {"coasting", "conservation",
       "A trolley coasts to rest: the loss is resistance times distance",
       "(M + J) v0^2 / 2 = f_r d, f_r = (Cr/R) M g", "conservation of energy"},
      {{{"resistance", "Cr/R", 0.005, 0.05}, &Coast::resistance},
       {{"speed", "m/s", 0.3, 2}, &Coast::speed},
       {{"mass", "kg", 40, 250}, &Coast::mass}},
      {{"easy", {0.01}}, {"plain", {0.02}}, {"hard", {0.03}}}, rolls, rests);
}

Family sliding_to_rest() {
  return make_family<Coast>({"sliding_to_rest", "conservation",
                             "A block slides to rest: the loss is friction times distance",
                             "M v0^2 / 2 = mu M g d", "conservation of energy"},
                            {{{"friction", "mu", 0.05, 0.8}, &Coast::resistance},
                             {{"speed", "m/s", 0.3, 2}, &Coast::speed},
                             {{"mass", "kg", 40, 250}, &Coast::mass}},
                            {{"slippery", {0.1}}, {"rough", {0.5}}}, slides, rests);
}

Family braking() {
  return make_family<Coast>(
      {"braking", "conservation", "Slipping brakes stop a trolley: the loss is torque times angle",
       "(M + J) v0^2 / 2 = 4 tau d / R", "conservation of energy"},
      {{{"torque", "N m", 0.3, 3}, &Coast::resistance},
       {{"speed", "m/s", 0.3, 1.5}, &Coast::speed},
       {{"mass", "kg", 60, 250}, &Coast::mass}},
      {{"weak", {0.5}}, {"strong", {2}}}, brakes, grips);
}

}  // namespace gurney::verification
