#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/units.h"
#include "studies/verification/family.h"
#include "studies/verification/scenes/scenes.h"
#include "studies/verification/scenes/small_scenes.h"

// A wheel set down at v0 without spin skids until it rolls: a bowling ball.
namespace gurney::verification {
namespace {

using namespace scenes;

constexpr double kStep = 0.0005;

struct Skid {
  double speed, friction, inertia;  // v0, mu, k = I / (m R^2)
  double mass = 10, radius = 0.05;
};

Caster wheel_of(const Skid& c) {
  Caster caster = rubber_caster();
  caster.tread.rolling_friction_length = 0;
  caster.swivels = false;
  caster.height += c.radius - caster.wheel_radius;
  caster.wheel_radius = c.radius;
  set_wheel_inertia(caster);
  return caster;
}

/// A wheel on a rigid fork below a small chassis that the fixture keeps upright. The mass that the
/// wheel carries counts as its own: only its spin inertia is in the closed form besides.
Response slide(const Skid& c, double duration, Runner& runner) {
  Caster caster = wheel_of(c);
  stiffen(caster.tread);
  caster.tread.static_friction = caster.tread.kinetic_friction = c.friction;
  caster.trail = 0;
  caster.wheel_axial_inertia = c.inertia * c.mass * c.radius * c.radius;
  caster.wheel_transverse_inertia = caster.wheel_axial_inertia;
  Scene scene = scene_of(single_caster(c.mass, caster));
  scene.items[0].initial.velocity.x() = c.speed;
  scene.items[0].initial.wheels_roll = false;
  scene.items[0].fixture = hold_rotations();
  return runner(scene, {}, run_for(duration, kStep, kStep));
}

/// One that rolls from the start goes on at its speed.
void roll_on(const Skid& c, Runner& runner) {
  Scene scene = scene_of(single_caster(c.mass, wheel_of(c)));
  scene.items[0].initial.velocity.x() = c.speed;
  scene.items[0].fixture = hold_rotations();
  const Response response = runner(scene, {}, run_for(1, 0.004, 1));
  runner.check("speed after 1 s if it rolls from the start", "m/s",
               response.items[0].history.back().velocity.x(),
               near_to(c.speed, 1e-9 * kG, "residual of the solve, 1e-9 g t"));
  runner.check("sliding loss if it rolls from the start", "J",
               response.items[0].energy.sliding_loss, exactly(0, "nothing slides"));
}

void skid(const Skid& c, Runner& runner) {
  const auto [v0, mu, k, mass, radius] = c;
  const double roll_time = v0 * k / (mu * kG * (1 + k)), v_end = v0 / (1 + k);
  const double duration = std::ceil(2 * roll_time / kStep) * kStep;
  const Response response = slide(c, duration, runner);

  // Until it rolls, the wheel is a block under constant force; the treads wind up over f^2 / (2
  // k_t) of energy. The change to rolling happens once, inside a step, and leaves the speed after
  // it alone: every step keeps the angular momentum about the contact line. Then the tread springs
  // back and rings against mass and wheel, with mu N / k_t sqrt(k_t / m_r) m_r / m.
  constexpr double kStiffness = 1e9;
  const double force = mu * mass * kG, wound = force * force / (2 * kStiffness) / (mass * v0);
  const double ring = mu * kG * std::sqrt(mass * k / (1 + k) / kStiffness);
  const double residual = 1e-9 * kG;
  Track displacement("displacement", "m",
                     "mu g dt^2 (the change to rolling inside a step); what the tread's wind-up "
                     "adds to the speed, f^2 / (2 k_t m v0), times the time; residual 1e-9 g t^2");
  Track velocity("velocity", "m/s",
                 "wind-up, f^2 / (2 k_t m v0); ringing mu g sqrt(m k / ((1 + k) k_t)) once it "
                 "rolls; mu g dt in the step of the change; residual 1e-9 g t");
  double first_roll = 0, slowest = 0;
  for (const Sample& s : response.items[0].history) {
    const double t = std::min(s.time, roll_time);
    displacement.add(s.time, s.displacement.x(),
                     v0 * t - mu * kG * t * t / 2 + v_end * (s.time - t),
                     mu * kG * kStep * kStep + (wound + residual) * s.time);
    const double changing = std::abs(s.time - roll_time) <= kStep ? mu * kG * kStep : 0;
    velocity.add(s.time, s.velocity.x(), v0 - mu * kG * t,
                 wound + residual * s.time + changing + (s.time > roll_time ? ring : 0));
    slowest = std::min(slowest, radius * s.wheels[0].wheel_rate);
    if (s.time > 0 && first_roll == 0 && s.wheels[0].mode != WheelMode::kSkids) first_roll = s.time;
  }
  runner.report(displacement, velocity);
  const Sample& end = response.items[0].history.back();
  const double loss = mass * v0 * v0 * k / (2 * (1 + k)), slip = v0 * roll_time / 2;
  // The slip falls by mu g (1 + 1/k) dt in a step.
  const double last = mu * kG * (1 + 1 / k) * kStep * kStep;
  // Deflection that rolls out of the patch takes its share of the slip from sliding.
  const double relaxed = force / (kStiffness * Tread().relaxation_length) * v_end * roll_time / 2;
  const double slipped = last + 2 * force / kStiffness + relaxed;
  runner.check("time at which it rolls", "s", first_roll,
               near_to(roll_time, 2 * kStep, "one step to change, one to report it: 2 dt"));
  runner.check("lowest rim speed", "m/s", slowest,
               near_to(0, 1e-9 * kG, "it never turns back; residual 1e-9 g t"));
  runner.check("rim speed at the end", "m/s", radius * end.wheels[0].wheel_rate,
               near_to(v_end, ring / k + wound + residual * duration,
                       "the ringing of the velocity, over k; wind-up; residual"));
  runner.check("distance that the patch slipped", "m",
               response.items[0].demands.wheels[0].skid_distance,
               near_to(slip, slipped,
                       "mu g (1 + 1/k) dt^2 in the last step; wind-up of the tread, 2 f/k_t; what "
                       "rolls out of the patch, f / (k_t sigma) v_end t / 2"));
  runner.check(
      "energy lost in sliding", "J", response.items[0].energy.sliding_loss,
      near_to(loss, force * slipped, "the tolerance of the slipped distance times mu m g"));
  roll_on(c, runner);
}

// --- a step in the floor
//
// The wheel turns about the step's edge, (r - h) below its axle. When its weight has left the floor
// the edge carries push and weight, R = sqrt(F^2 + N^2), through the axle; its tread deflects by
// d = R / (2 k) there, so that the axle is r - d from it:
//
//     F / N = sqrt((r - d)^2 - (r - h)^2) / (r - h),
//
// which gets less as it rises. N is the load of the axle at rest, half of the weight.

constexpr double kStiffness = 1e7;                       // of the treads [N/m]
constexpr double kWidth = 0.001;                         // of the push
constexpr double kWheelbase = 0.8, kCenterHeight = 0.5;  // of the trolley [m]

struct Step {
  double radius, height;  // of the wheel, of the step [m]
};

/// Four rigid casters whose front wheels touch a step, pushed at the height of the axles.
Response pushed(const Step& step, double force, Runner& runner) {
  Scene scene = scene_of({});
  Tread tread = small::bare_tread(kStiffness, kStiffness);
  tread.normal_damping = 3e4;  // some 50 % of critical for a quarter of the mass: no rebound
  tread.tangential_damping = 1e3;
  scene.items[0].model = small::trolley({0, 0, 0, 0}, tread);
  double front = 0;
  for (Caster& caster : scene.items[0].model.casters) {
    caster.swivels = false;
    caster.trail = 0;
    caster.fork_center_of_mass.x() = 0;
    const double change = step.radius - caster.wheel_radius;
    caster.wheel_radius = step.radius;
    caster.height += change;
    caster.mount.z() = caster.height;
    front = std::max(front, caster.mount.x());
  }
  const double reach = std::sqrt(2 * step.radius * step.height - step.height * step.height);
  scene.room = {{"step",
                 "",
                 {front + reach + 0.5 + 1e-4, 0, step.height / 2},
                 Quaternion::Identity(),
                 RoomBox{{1, 4, step.height}}}};
  scene.items[0].loads = {
      PointForce{"push", {-0.4, 0, step.radius}, Vector3::UnitX(), {0, 1, 3}, {0, force, force}}};
  return runner(scene, {}, scenes::run_for(2.5, 1e-3, 1e-3));
}

void climb(const Step& c, Runner& runner) {
  const double load =
      scenes::total_mass(small::trolley({0, 0, 0, 0}, Tread())) * kStandardGravity / 2;
  const double r = c.radius, h = c.height;
  const auto force_at = [&](double radius) {
    return load * std::sqrt(radius * radius - (r - h) * (r - h)) / (r - h);
  };
  double force = force_at(r);
  for (int i = 0; i < 5; ++i) force = force_at(r - std::hypot(force, load) / (2 * kStiffness));
  const double sink = load / (2 * kStiffness);
  const double pitch =
      2 * sink / kWheelbase * (kCenterHeight + kWheelbase * force / load) / kWheelbase;
  const double found = locate(0.96 * force, 1.04 * force, kWidth * force, [&](double push) {
    return pushed(c, push, runner).items[0].demands.peak_displacement > 0.2;
  });
  runner.check("push that climbs", "N", found,
               near_to(force, force * (pitch + kWidth / 2),
                       "of it: the treads behind sink by s = N / 2k, which tilts it by s / l and "
                       "so shifts its centre, h high, and lowers the push, twice (s / l) (h / l + "
                       "F / N); half of the last bracket, 0.05 %"));
  for (const double share : {0.99, 1.01})
    runner.check(fmt::format("energy balance error at {} of it", share), "",
                 pushed(c, share * force, runner).quality.energy_closure,
                 near_to(0, 0.003, "0.3 % of the energy in play at steps of 1 ms"));
}

/// The push stays below some three times the load.
bool can_climb(const Step& c) { return c.height < 0.65 * c.radius; }

}  // namespace

Family skid_to_roll() {
  return make_family<Skid>(
      {"skid_to_roll", "casters", "A wheel that is set down without spin skids until it rolls",
       "v_end = v0 / (1 + k), t = v0 k / (mu g (1 + k)), x = v0 t - mu g t^2 / 2, k = I / (m R^2)",
       "any textbook of rigid-body motion, such as Landau & Lifshitz, Mechanics"},
      fields(FIELD(Skid, speed, "m/s", 0.3, 3), FIELD(Skid, friction, "mu", 0.1, 0.9),
             FIELD(Skid, inertia, "I/(m R^2)", 0.05, 1), FIELD(Skid, mass, "kg", 5, 60),
             FIELD(Skid, radius, "m", 0.0375, 0.1)),
      cases(at("cylinder", 1, 0.3, 0.5), at("fast", 2, 0.3, 0.5), at("hoop", 1, 0.6, 1),
            at("slippery", 0.5, 0.15, 0.2), at("light_rim", 3, 0.8, 0.05)),
      skid);
}

Family step_climb() {
  return make_family<Step>(
      {"step_climb", "casters", "Wheels are pushed against a step, slowly",
       "F / N = sqrt((r - d)^2 - (r - h)^2) / (r - h), d = sqrt(F^2 + N^2) / (2 k)",
       "statics of a wheel at an edge"},
      fields(FIELD(Step, radius, "m", 0.025, 0.1), FIELD(Step, height, "m", 0.006, 0.03)),
      cases(at("50_10", 0.05, 0.01), at("50_20", 0.05, 0.02), at("75_20", 0.075, 0.02),
            at("37.5_10", 0.0375, 0.01), at("25_10", 0.025, 0.01)),
      climb, can_climb);
}

}  // namespace gurney::verification
