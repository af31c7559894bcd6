#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/units.h"
#include "studies/verification/family.h"
#include "studies/verification/scenes/scenes.h"
#include "studies/verification/scenes/small_scenes.h"

// The wheel turns about the step's edge, (r - h) below its axle and sqrt(2 r h - h^2) ahead: it
// leaves the floor when F (r - h) = N sqrt(2 r h - h^2), which gets less as it rises. Push and edge
// meet in the axle, so the load N of the axle is that at rest: half of the weight.
namespace gurney::verification {
namespace {

constexpr double kStiffness = 1e7;  // of the treads [N/m]
constexpr double kWidth = 0.005;    // of the push

struct Step {
  double radius, height;  // of the wheel, of the step [m]
};

/// Four rigid casters whose front wheels touch a step, pushed at the height of the axles.
Response pushed(const Step& step, double force, const Runner& runner, Findings& findings) {
  Scene scene;
  Tread tread = small::bare_tread(kStiffness, kStiffness);
  tread.normal_damping = 3e4;  // some 50 % of critical for a quarter of the mass: no rebound
  tread.tangential_damping = 1e3;
  scene.items[0].model = small::trolley({0, 0, 0, 0}, tread);
  double front = 0;
  for (Caster& caster : scene.items[0].model.casters) {
    caster.swivels = false;
    caster.trail = 0;
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
  Excitation excitation;
  excitation.forces = {{"push", {-0.4, 0, step.radius}, Vector3::UnitX(), {0, 4}, {force, force}}};
  return runner(findings, scene, excitation, scenes::run_for(2, 1e-3, 1e-3));
}

Findings climb(const Step& c, const Runner& runner) {
  Findings findings;
  const double load =
      scenes::total_mass(small::trolley({0, 0, 0, 0}, Tread())) * kStandardGravity / 2;
  const double r = c.radius, h = c.height, reach = std::sqrt(2 * r * h - h * h);
  const double force = load * reach / (r - h);
  const double found = locate(0.96 * force, 1.04 * force, kWidth * force, [&](double push) {
    return pushed(c, push, runner, findings).items[0].demands.peak_displacement > 0.2;
  });
  findings.checks.push_back(
      {"push that climbs", "N", found, force, force * (0.01 + kWidth / 2),
       "1 %: treads yield by 25 to 50 um, which turns the line from edge to axle by 1e-3, and a "
       "sudden push brings some energy; half of the last bracket, 0.25 %"});
  for (const double share : {0.99, 1.01})
    findings.checks.push_back({fmt::format("closure of the energy account at {} of it", share), "",
                               pushed(c, share * force, runner, findings).quality.energy_closure, 0,
                               0.003, "0.3 % of the energy in play at steps of 1 ms"});
  return findings;
}

}  // namespace

Family step_climb() {
  Family family = make_family<Step>(
      {"step_climb", "casters", "Wheels are pushed against a step",
       "F / N = sqrt(2 r h - h^2) / (r - h)", "statics of a wheel at an edge"},
      {{{"radius", "m", 0.025, 0.1}, &Step::radius}, {{"height", "m", 0.006, 0.03}, &Step::height}},
      {{"50_10", {0.05, 0.01}},
       {"50_20", {0.05, 0.02}},
       {"75_20", {0.075, 0.02}},
       {"37.5_10", {0.0375, 0.01}},
       {"25_10", {0.025, 0.01}}},
      climb);
  family.drawn = false;  // the energy of a sudden push has no formula here
  return family;
}

}  // namespace gurney::verification
