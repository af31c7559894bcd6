#include <cmath>
#include <numbers>

#include "engine/solver/quadrature.h"
#include "engine/solver/tread_crossing.h"
#include "studies/verification/cases/sliding_block.h"
#include "studies/verification/family.h"
#include "studies/verification/scenes/blocks.h"
#include "studies/verification/scenes/small_scenes.h"

namespace gurney::verification {
namespace {

// --- the floor drops away faster than gravity, then comes back: the trolley flies and lands

struct Drop {
  double acceleration, time;  // of the floor, down and then up [g], of each [s]
};

constexpr double kSample = 1e-3, kStep = 1e-4, kStiff = 3e7;  // [s], [s], [N/m]

/// Its height z over the floor, from the unloaded tread, whatever it stands on. The treads carry it
/// with z = -(g/w^2) and throw it: z'' = a g - w^2 (z + g/w^2). From z = 0 on it is free, z'' = (a
/// - 1) g until the last sample of the fall, then, as samples are joined by lines, along a line of
/// 2 ms to -(a + 1) g.
struct Flight {
  double unload, thrown;  ///< time and speed at which z = 0 [s], [m/s]
  double landing, speed;  ///< time and speed at which it is again

  Flight(const Drop& drop, double omega) {
    const double a = drop.acceleration, T = drop.time;
    unload = std::acos((a - 1) / a) / omega;
    thrown = kG / omega * std::sqrt(a * a - (a - 1) * (a - 1));
    const double up = (a - 1) * kG, down = (a + 1) * kG, free = T - kSample - unload;
    const double z1 = thrown * free + up * free * free / 2, v1 = thrown + up * free;
    const double line = 2 * kSample, bent = up + down;
    const double z2 = z1 + v1 * line + (up / 2 - bent / 6) * line * line;
    const double v2 = v1 + (up - bent / 2) * line;
    speed = std::sqrt(v2 * v2 + 2 * down * z2);
    landing = T + kSample + (v2 + speed) / down;
  }
};

/// Error of the balance from a touch or a leave inside a step: the work of a spring over the part of
/// the step in which it does not act, k / 2 s^2. Steps end where wheels are foreseen to cross, so
/// that s is at most the way in the share of a step that is left inside.
double misbooked(double speed) {
  return 4 * kStiff / 2 * std::pow(TreadCrossings::kNearEnd * speed * kStep, 2);
}

void close(const EquipmentModel& item, const Response& response, double speed, Runner& runner) {
  const double mass = whole_item(item).mass;
  Track closure("energy balance error", "J",
                "residual of the solve, 1e-9 M g dt of momentum in each step, at the speed of the "
                "landing; of the throw and the landing 4 k s^2 / 2 each, s = 0.02 v dt, for steps "
                "end where wheels leave and land within 0.02 of a step");
  const auto& history = response.items[0].history;
  for (const Sample& at : history)
    closure.add(at.time, at.energy.closure(response.items[0].stored_energy_at_start), 0,
                1e-9 * mass * kG * history.back().time * speed + 2 * misbooked(speed));
  runner.report(closure);
}

void fly(const Drop& drop, Runner& runner) {
  const double a = drop.acceleration, T = kSample * std::round(drop.time / kSample);
  const Scene scene =  // it does not pitch
      scene_of(small::trolley({0, 0, 180, 180}, small::bare_tread(kStiff, kStiff)));
  const auto half = static_cast<Eigen::Index>(std::lround(T / kSample));
  Eigen::Matrix3Xd motion = Eigen::Matrix3Xd::Zero(3, 2 * half + 1);
  motion.row(2).head(half).setConstant(-a * kG);
  motion.row(2).tail(half).setConstant(a * kG);
  const FloorMotion floor(kSample, motion);
  const double omega = std::sqrt(4 * kStiff / whole_item(scene.items[0].model).mass);
  const Flight flight({a, T}, omega);
  const Response response =
      runner(scene, floor, blocks::run_for(flight.landing + 0.02, kStep, kStep));
  double take_off = -1, landing = -1, approach = 0;
  for (const Sample& s : response.items[0].history) {
    const bool up = s.wheels[0].mode == WheelMode::kLifted;
    if (up && take_off < 0) take_off = s.time;
    if (up && landing < 0) approach = -s.velocity.z();
    if (!up && take_off >= 0 && landing < 0) landing = s.time;
  }
  // While the spring is loaded the method errs by 0.0404 (w dt)^2 of the angle and, where it
  // ends inside a step, gamma^2 (w dt)^2 / 2 of the speed; the fall carries it on.
  const double phase = omega * kStep;
  const double method = (0.0404 * std::numbers::pi / 2 + kSdirkGamma * kSdirkGamma / 2) * phase *
                        phase * flight.thrown;
  const double late = method * flight.landing / flight.speed;
  const double down = (a + 1) * kG;
  runner.check("time at which it takes off", "s", take_off,
               near_to(flight.unload, kStep, "the step of 0.1 ms at whose end it is in the air"));
  runner.check(
      "time at which it lands", "s", landing,
      near_to(flight.landing, kStep + late,
              "the step of 0.1 ms at whose end it has landed; what the method misses of the throw, "
              "(0.0404 pi/2 + gamma^2/2) (w dt)^2 of its speed, over that of landing"));
  runner.check(
      "speed of the landing", "m/s", approach,
      near_to(flight.speed, down * (kStep + late) + method,
              "(a + 1) g dt, it is that of the last step in the air; and that of the throw"));
  runner.check("wheels lifted", "", response.items[0].demands.most_wheels_lifted,
               exactly(4, "it flies"));
  close(scene.items[0].model, response, flight.speed, runner);
  runner.check("energy balance error over the energy", "", response.quality.energy_closure,
               near_to(0, 2 * std::pow(TreadCrossings::kNearEnd * omega * kStep, 2) + 1e-9,
                       "2 (0.02 omega dt)^2: the line above over M v^2 / 2; 1e-9 for the solve"));
}

// --- elastic treads without friction give a wheel that meets a wall its speed back

struct Wall {
  double speed, swivels;  // [m/s], 0 or 1
};

void bounce(const Wall& c, Runner& runner) {
  Scene scene = scene_of({});
  Tread tread = small::bare_tread(3e5, 1e5);
  tread.static_friction = tread.kinetic_friction = 0;
  scene.items[0].model = small::trolley({0, 0, 0, 0}, tread);
  for (Caster& caster : scene.items[0].model.casters) {
    caster.swivels = c.swivels > 0;
    caster.mount.z() = caster.height;
  }
  scene.items[0].model.shape = {{{0, 0, 0.8}, {0.2, 0.2, 0.2}}};
  scene.items[0].initial.velocity = {c.speed, 0, 0};
  scene.room = {{"wall", "", {0.65, 0, 0.5}, Quaternion::Identity(), RoomBox{{0.2, 4, 1}}}};
  for (int dof : {2, 3, 4}) scene.items[0].fixture.guides[dof] = {Guide::Kind::kHeld, 0, 0, 0};
  const Response response = runner(scene, {}, blocks::run_for(0.4 / c.speed, 0.004, 0.004));
  const ImpactSteps steps(1, 1, 1, 1);  // no point has a larger effective mass than the trolley
  runner.check("speed back", "m/s", -response.items[0].history.back().velocity.x(),
               near_to(c.speed, 2 * steps.speed_error() * c.speed,
                       "gamma^2 phi^2 of the speed for each of two treads, phi = pi/32 the phase "
                       "of a step: where they touch and part inside steps"));
  runner.check("energy balance error", "", response.quality.energy_closure,
               near_to(0, 4 * steps.speed_error(), "twice that of the speed"));
  runner.check("wheels that hit the wall", "", response.impacts.size(),
               exactly(2, "both front wheels, once"));
}

}  // namespace

Family flight() {
  return make_family<Drop>(
      {"flight", "vertical", "The floor drops away faster than gravity: a trolley flies and lands",
       "z'' = (a - 1) g, then -(a + 1) g, from the speed with which the treads throw it, g/w "
       "sqrt(a^2 - (a - 1)^2) at cos(w t) = (a - 1)/a",
       "free fall"},
      fields(FIELD(Drop, acceleration, "g", 1.15, 1.9), FIELD(Drop, time, "s", 0.06, 0.35)),
      cases(at("plain", 1.5, 0.1), at("long", 1.2, 0.3), at("strong", 1.8, 0.08)), fly);
}

Family wheel_at_wall() {
  return make_family<Wall>(
      {"wheel_at_wall", "impacts", "Elastic wheels without friction meet a wall", "v' = -v",
       "energy"},
      fields(FIELD(Wall, speed, "m/s", 0.2, 2.5), FIELD(Wall, swivels, "", 0, 1, true)),
      cases(at("slow", 0.3, 0), at("plain", 1, 0), at("fast", 2, 0), at("slow_swivels", 0.3, 1),
            at("plain_swivels", 1, 1), at("fast_swivels", 2, 1)),
      bounce);
}

}  // namespace gurney::verification
