#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/units.h"
#include "studies/verification/family.h"
#include "studies/verification/scenes/scenes.h"
#include "studies/verification/scenes/small_scenes.h"

// The wheel turns about the step's edge, (r - h) below its axle. When its weight has left the floor
// the edge carries push and weight, R = sqrt(F^2 + N^2), through the axle; its tread deflects by
// d = R / (2 k) there, so that the axle is r - d from it:
//
//     F / N = sqrt((r - d)^2 - (r - h)^2) / (r - h),
//
// which gets less as it rises. N is the load of the axle at rest, half of the weight.
namespace gurney::verification {
namespace {

constexpr double kStiffness = 1e7;                       // of the treads [N/m]
constexpr double kWidth = 0.001;                         // of the push
constexpr double kWheelbase = 0.8, kCenterHeight = 0.5;  // of the trolley [m]

struct Step {
  double radius, height;  // of the wheel, of the step [m]
};

/// Four rigid casters whose front wheels touch a step, pushed at the height of the axles.
Response pushed(const Step& step, double force, const Runner& runner, Findings& findings) {
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
  return runner(findings, scene, {}, scenes::run_for(2.5, 1e-3, 1e-3));
}

Findings climb(const Step& c, const Runner& runner) {
  Findings findings;
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
    return pushed(c, push, runner, findings).items[0].demands.peak_displacement > 0.2;
  });
  findings.checks.push_back({"push that climbs", "N", found, force, force * (pitch + kWidth / 2),
                             "of it: the treads behind sink by s = N / 2k, which tilts it by s / l "
                             "and so shifts its centre, "
                             "h high, and lowers the push, twice (s / l) (h / l + F / N); half of "
                             "the last bracket, 0.05 %"});
  for (const double share : {0.99, 1.01})
    findings.checks.push_back({fmt::format("energy balance error at {} of it", share), "",
                               pushed(c, share * force, runner, findings).quality.energy_closure, 0,
                               0.003, "0.3 % of the energy in play at steps of 1 ms"});
  return findings;
}

/// The push stays below some three times the load.
bool can_climb(const Step& c) { return c.height < 0.65 * c.radius; }

}  // namespace

Family step_climb() {
  return make_family<Step>(
      {"step_climb", "casters", "Wheels are pushed against a step, slowly",
       "F / N = sqrt((r - d)^2 - (r - h)^2) / (r - h), d = sqrt(F^2 + N^2) / (2 k)",
       "statics of a wheel at an edge"},
      {{{"radius", "m", 0.025, 0.1}, &Step::radius}, {{"height", "m", 0.006, 0.03}, &Step::height}},
      {{"50_10", {0.05, 0.01}},
       {"50_20", {0.05, 0.02}},
       {"75_20", {0.075, 0.02}},
       {"37.5_10", {0.0375, 0.01}},
       {"25_10", {0.025, 0.01}}},
      climb, can_climb);
}

}  // namespace gurney::verification
