#include <algorithm>
#include <cmath>

#include "studies/verification/family.h"
#include "studies/verification/gravity.h"
#include "studies/verification/scenes/scenes.h"

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
Response slide(const Skid& c, double duration, const Runner& runner, Findings& findings) {
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
  return runner(findings, scene, {}, run_for(duration, kStep, kStep));
}

/// One that rolls from the start goes on at its speed.
void roll_on(const Skid& c, const Runner& runner, Findings& findings) {
  Scene scene = scene_of(single_caster(c.mass, wheel_of(c)));
  scene.items[0].initial.velocity.x() = c.speed;
  scene.items[0].fixture = hold_rotations();
  const Response response = runner(findings, scene, {}, run_for(1, 0.004, 1));
  findings.checks.push_back({"speed after 1 s if it rolls from the start", "m/s",
                             response.items[0].history.back().velocity.x(), c.speed, 1e-9 * kG,
                             "residual of the solve, 1e-9 g t"});
  findings.checks.push_back({"sliding loss if it rolls from the start", "J",
                             response.items[0].energy.sliding_loss, 0, 0, "nothing slides"});
}

Findings skid(const Skid& c, const Runner& runner) {
  Findings findings;
  const auto [v0, mu, k, mass, radius] = c;
  const double roll_time = v0 * k / (mu * kG * (1 + k)), v_end = v0 / (1 + k);
  const double duration = std::ceil(2 * roll_time / kStep) * kStep;
  const Response response = slide(c, duration, runner, findings);

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
  displacement.report(findings);
  velocity.report(findings);
  const Sample& end = response.items[0].history.back();
  const double loss = mass * v0 * v0 * k / (2 * (1 + k)), slip = v0 * roll_time / 2;
  // The slip falls by mu g (1 + 1/k) dt in a step.
  const double last = mu * kG * (1 + 1 / k) * kStep * kStep;
  // Deflection that rolls out of the patch takes its share of the slip from sliding.
  const double relaxed = force / (kStiffness * Tread().relaxation_length) * v_end * roll_time / 2;
  const double slipped = last + 2 * force / kStiffness + relaxed;
  findings.checks.push_back({"time at which it rolls", "s", first_roll, roll_time, 2 * kStep,
                             "one step to change, one to report it: 2 dt"});
  findings.checks.push_back(
      {"lowest rim speed", "m/s", slowest, 0, 1e-9 * kG, "it never turns back; residual 1e-9 g t"});
  findings.checks.push_back({"rim speed at the end", "m/s", radius * end.wheels[0].wheel_rate,
                             v_end, ring / k + wound + residual * duration,
                             "the ringing of the velocity, over k; wind-up; residual"});
  findings.checks.push_back({"distance that the patch slipped", "m",
                             response.items[0].demands.wheels[0].skid_distance, slip, slipped,
                             "mu g (1 + 1/k) dt^2 in the last step; wind-up of the tread, 2 f/k_t; "
                             "what rolls out of the patch, f / (k_t sigma) v_end t / 2"});
  findings.checks.push_back({"energy lost in sliding", "J", response.items[0].energy.sliding_loss,
                             loss, force * slipped,
                             "the tolerance of the slipped distance times mu m g"});
  roll_on(c, runner, findings);
  return findings;
}

}  // namespace

Family skid_to_roll() {
  return make_family<Skid>(
      {"skid_to_roll", "casters", "A wheel that is set down without spin skids until it rolls",
       "v_end = v0 / (1 + k), t = v0 k / (mu g (1 + k)), x = v0 t - mu g t^2 / 2, k = I / (m R^2)",
       "any textbook of rigid-body motion, such as Landau & Lifshitz, Mechanics"},
      {{{"speed", "m/s", 0.3, 3}, &Skid::speed},
       {{"friction", "mu", 0.1, 0.9}, &Skid::friction},
       {{"inertia", "I/(m R^2)", 0.05, 1}, &Skid::inertia},
       {{"mass", "kg", 5, 60}, &Skid::mass},
       {{"radius", "m", 0.0375, 0.1}, &Skid::radius}},
      {{"cylinder", {1, 0.3, 0.5}},
       {"fast", {2, 0.3, 0.5}},
       {"hoop", {1, 0.6, 1}},
       {"slippery", {0.5, 0.15, 0.2}},
       {"light_rim", {3, 0.8, 0.05}}},
      skid);
}

}  // namespace gurney::verification
