#include <cmath>

#include "studies/verification/family.h"
#include "studies/verification/scenes/scenes.h"

namespace gurney::verification {
namespace {

using namespace scenes;

struct Roll {
  double speed, stiff, swivels;  // [m/s], treads, casters
  double mass = 96.5;
};

void roll(const Roll& c, Runner& runner) {
  constexpr double kDuration = 60;
  ItemOptions options;
  options.total_mass = c.mass;
  Caster& caster = options.caster;
  if (c.stiff != 0) stiffen(caster.tread);
  caster.swivels = c.swivels != 0;
  caster.tread.rolling_friction_length = 0;
  caster.tread.tangential_damping = 100;  // above I_p v / trail^3: no flutter
  Scene scene = scene_of(trolley(options));
  scene.items[0].initial.velocity.x() = c.speed;
  const Response response = runner(scene, {}, run_for(kDuration, 0.004, 1));
  const char* const why =
      "1e-9 of the speed: no sleeping, no drag; the solve's residual, 1e-9 g dt in each step, "
      "could add up to 6e-7 m/s but does not";
  Track velocity("velocity", "m/s", why), path("displacement", "m", why);
  Track across("displacement across", "m", "1e-9 m");
  for (const Sample& s : response.items[0].history) {
    velocity.add(s.time, s.velocity.x(), c.speed, 1e-9 * c.speed);
    path.add(s.time, s.displacement.x(), c.speed * s.time, 1e-9 * c.speed * kDuration);
    across.add(s.time, s.displacement.y(), 0, 1e-9);
  }
  runner.report(velocity, path, across);
  runner.check("energy lost", "J", response.items[0].energy.loss(), near_to(0, 1e-9, "1e-9 J"));
}

// --- coming to rest
//
// An item that moves at v0 comes to rest when a force has taken its kinetic energy: the distance gives the
// force, the energy balance shows whose it was.

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
               const Fixture& fixture, Runner& runner) {
  Scene scene = scene_of(item);
  scene.items[0].initial.velocity = velocity;
  scene.items[0].initial.wheels_roll = item.casters[0].brake_torque < INFINITY;
  scene.items[0].fixture = fixture;
  return runner(scene, {}, run_for(duration, step, 0.05));
}

/// @param force       that stops it, all wheels [N]
/// @param inertia     M, or M + J
void compare(const Response& response, double loss, const std::string& of, double force,
             double inertia, double speed, double step, Runner& runner) {
  const double a = force / inertia, distance = speed * speed / (2 * a);
  // Treads wind up over f / k, k = 4e9 N/m at least 10/11 of it, and the stop falls inside a step.
  const double wound = 2 * force / (4e9 * 10 / 11), stop = a * step * step;
  const double residual = 1e-9 * kG * speed / a * speed / a;
  const double slip = force / (4 * 1e9 * Tread().relaxation_length);
  const ItemResponse& item = response.items[0];
  const char* const terms =
      "wind-up of the treads, 2 f / k; the stop inside a step, a dt^2; residual 1e-9 g t^2";
  Track velocity(
      "speed", "m/s",
      "a times the time to wind up, 2 f / (k v0), and a dt at the stop; residual 1e-9 g t");
  for (const Sample& s : item.history) {
    const double v = std::max(0.0, speed - a * s.time);
    velocity.add(s.time, s.velocity.head<2>().norm(), v,
                 a * wound / speed + 1e-9 * kG * s.time +
                     std::sqrt(force * force / (4e9 * inertia)) +
                     (v < 2 * a * step ? a * step : 0));
  }
  runner.report(velocity);
  runner.check("distance", "m", item.demands.residual_displacement,
               near_to(distance, wound + stop + residual, terms));
  runner.check(
      of, "J", loss,
      near_to(inertia * speed * speed / 2, force * (wound + stop + residual + slip * distance),
              std::string("the force times the tolerance of the distance, and the slip of rolling "
                          "treads, f / (n k_t sigma), times the distance: ") +
                  terms));
}

void rolls(const Coast& c, Runner& runner) {
  const EquipmentModel item = stiff_trolley(c, c.resistance, 0);
  const double inertia = c.mass + wheel_inertia_mass(item), force = c.resistance * c.mass * kG;
  const double time = c.speed * inertia / force;
  const Response response =
      coast(item, {c.speed, 0, 0}, 0.004, time + 1, hold_rotations(false, true, false), runner);
  compare(response, response.items[0].energy.rolling_loss, "rolling loss", force, inertia, c.speed,
          0.004, runner);
  runner.check("sliding loss", "J", response.items[0].energy.sliding_loss,
               near_to(0, 1e-9, "rolling wheels do not slide: 1e-9 J"));
}

void slides(const Coast& c, Runner& runner) {
  ItemOptions options;
  options.total_mass = c.mass;
  stiffen(options.caster.tread);
  options.caster.tread.static_friction = options.caster.tread.kinetic_friction = c.resistance;
  const EquipmentModel item = locked_block(options);
  const double force = c.resistance * c.mass * kG;
  const Response response = coast(item, c.speed * Vector3(0.8, 0.6, 0), 0.001,
                                  c.speed / (c.resistance * kG) + 1, hold_rotations(), runner);
  compare(response, response.items[0].energy.sliding_loss, "sliding loss", force, c.mass, c.speed,
          0.001, runner);
}

void brakes(const Coast& c, Runner& runner) {
  const EquipmentModel item = stiff_trolley(c, 0, c.resistance);
  const double inertia = c.mass + wheel_inertia_mass(item);
  const double force = 4 * c.resistance / item.casters[0].wheel_radius;
  const Response response = coast(item, {c.speed, 0, 0}, 0.001, c.speed * inertia / force + 1,
                                  hold_rotations(false, true, false), runner);
  compare(response, response.items[0].energy.axle_loss, "axle loss", force, inertia, c.speed, 0.001,
          runner);
}

/// The wheels roll: the brakes need less than half of mu_s M g.
bool grips(const Coast& c) { return 4 * c.resistance / 0.05 < 0.3 * c.mass * kG; }

/// It rests within 30 s.
bool rests(const Coast& c) { return c.speed / (c.resistance * kG) < 30; }

// --- losses of treads and swivels

// A rolling patch under the force f slips by f / (k_t sigma) of its travel s (relaxation), which
// takes f^2 s / (k_t sigma) for each wheel, and so much less goes into the wheels' turning. In a
// coast, f = f_r - J a2 of all wheels together.
struct Soft {
  double stiffness = 1e5, resistance = 0.02, speed = 1, mass = 96.5;  // k_t [N/m], Cr/R, [m/s]
};

void relax(const Soft& c, Runner& runner) {
  constexpr double kDuration = 2;
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
  const Response response = runner(scene, {}, run_for(kDuration, 0.001, kDuration));
  const double travel = c.speed * kDuration - a2 * kDuration * kDuration / 2;
  const double force = (resistance - inertia * a2) / 4;
  const double slip = force / (c.stiffness * tread.relaxation_length);
  const double start = tread.relaxation_length / travel;
  const double expected = 4 * force * slip * travel;
  runner.check("relaxation loss", "J", response.items[0].energy.relaxation_loss,
               near_to(expected, 2 * (start + slip) * expected,
                       "2 (sigma / s + slip) of it: the start, where the force builds up over a "
                       "travel of sigma, and slip^2 are left out"));
  // While the patch winds up, x1 = f / (n k_t 10 / 11), the wheels do not turn; nor do they by the
  // slip.
  const double turning = resistance * travel * (1 - slip);
  runner.check(
      "rolling loss", "J", response.items[0].energy.rolling_loss,
      near_to(turning,
              resistance * (travel * slip * (2 * start + slip) +
                            2 * resistance / (4 * c.stiffness * 10 / 11)),
              "f_r s slip (2 sigma / s + slip), and 2 f_r / k of path while the treads wind up"));
}

/// Still in motion at the end.
bool goes_on(const Soft& c) { return c.speed > 1.5 * 2 * c.resistance * kG; }

// A caster towed from a heading psi0 turns into line; its swivel friction takes c |psi0 - psi|.
struct Swivel {
  double heading, friction = 0.05, mass = 25, speed = 0.3;  // [rad], [N m], [kg], [m/s]
};

void turn(const Swivel& c, Runner& runner) {
  Caster caster = rubber_caster();
  caster.swivel.coulomb = c.friction;
  caster.heading = c.heading;
  Scene scene = scene_of(single_caster(c.mass, caster));
  scene.items[0].fixture = tow(c.speed);
  const Response response = runner(scene, {}, run_for(0.6 / c.speed, 0.001, 0.001));
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
  runner.check("swivel loss", "J", response.items[0].energy.swivel_loss,
               near_to(c.friction * turned,
                       2 * c.friction * c.friction / spring * turns + 1e-3 * 1e-3 * c.friction,
                       "elastic wind-up of the stuck bearing, 2 c^2 / (10 k_t R^2) for each of its "
                       "turns; 1e-6 rad"));
}

}  // namespace

Family free_rolling() {
  return make_family<Roll>(
      {"free_rolling", "conservation", "A trolley without resistance rolls on for a minute",
       "v = v0, x = v0 t, no loss", "Newton's first law"},
      fields(FIELD(Roll, speed, "m/s", 0.1, 3), FIELD(Roll, stiff, "1 stiff treads", 0, 1, true),
             FIELD(Roll, swivels, "1 swivel casters", 0, 1, true),
             FIELD(Roll, mass, "kg", 40, 250)),
      cases(at("slow_soft_rigid", 0.1, 0, 0), at("slow_soft_swivel", 0.1, 0, 1),
            at("slow_stiff_rigid", 0.1, 1, 0), at("slow_stiff_swivel", 0.1, 1, 1),
            at("soft_rigid", 1, 0, 0), at("soft_swivel", 1, 0, 1), at("stiff_rigid", 1, 1, 0),
            at("stiff_swivel", 1, 1, 1), at("fast_soft_rigid", 3, 0, 0),
            at("fast_soft_swivel", 3, 0, 1), at("fast_stiff_rigid", 3, 1, 0),
            at("fast_stiff_swivel", 3, 1, 1)),
      roll);
}

Family coasting() {
  return make_family<Coast>(
      {"coasting", "conservation",
       "A trolley coasts to rest: the loss is resistance times distance",
       "(M + J) v0^2 / 2 = f_r d, f_r = (Cr/R) M g", "conservation of energy"},
      fields(FIELD(Coast, resistance, "Cr/R", 0.005, 0.05), FIELD(Coast, speed, "m/s", 0.3, 2),
             FIELD(Coast, mass, "kg", 40, 250)),
      cases(at("easy", 0.01), at("plain", 0.02), at("hard", 0.03)), rolls, rests);
}

Family sliding_to_rest() {
  return make_family<Coast>(
      {"sliding_to_rest", "conservation",
       "A block slides to rest: the loss is friction times distance", "M v0^2 / 2 = mu M g d",
       "conservation of energy"},
      fields(in(&Coast::resistance, "friction", "mu", 0.05, 0.8),
             FIELD(Coast, speed, "m/s", 0.3, 2), FIELD(Coast, mass, "kg", 40, 250)),
      cases(at("slippery", 0.1), at("rough", 0.5)), slides, rests);
}

Family braking() {
  return make_family<Coast>(
      {"braking", "conservation", "Slipping brakes stop a trolley: the loss is torque times angle",
       "(M + J) v0^2 / 2 = 4 tau d / R", "conservation of energy"},
      fields(in(&Coast::resistance, "torque", "N m", 0.3, 3), FIELD(Coast, speed, "m/s", 0.3, 1.5),
             FIELD(Coast, mass, "kg", 60, 250)),
      cases(at("weak", 0.5), at("strong", 2)), brakes, grips);
}

Family relaxation() {
  return make_family<Soft>(
      {"relaxation", "conservation", "A rolling soft tread forgets its deflection and loses energy",
       "W = f^2 s / (k_t sigma) for each wheel, f = (f_r - J a2) / n",
       "first-order relaxation of a tyre, Pacejka, Tyre and Vehicle Dynamics"},
      fields(FIELD(Soft, stiffness, "N/m", 5e4, 1e6), FIELD(Soft, resistance, "Cr/R", 0.005, 0.03),
             FIELD(Soft, speed, "m/s", 0.5, 2), FIELD(Soft, mass, "kg", 60, 250)),
      cases(at("plain")), relax, goes_on);
}

Family swivel_friction() {
  return make_family<Swivel>(
      {"swivel_friction", "conservation", "A towed caster turns against the friction of its swivel",
       "W = c times the angle turned", "work of a constant torque"},
      fields(FIELD(Swivel, heading, "rad", 0.3, 2.8), FIELD(Swivel, friction, "N m", 0.01, 0.1),
             FIELD(Swivel, mass, "kg", 15, 60), FIELD(Swivel, speed, "m/s", 0.1, 0.5)),
      cases(at("ahead", 0.5), at("crosswise", 1.5), at("behind", 2.5)), turn);
}

}  // namespace gurney::verification
