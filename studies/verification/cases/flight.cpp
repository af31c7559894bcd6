#include <cmath>
#include <numbers>

#include "engine/base/units.h"
#include "studies/verification/cases.h"
#include "studies/verification/cases/sliding_block.h"
#include "studies/verification/scenes/blocks.h"
#include "studies/verification/scenes/small_scenes.h"

namespace gurney::verification {
namespace {

constexpr double kG = kStandardGravity;

// --- the floor drops away faster than gravity, then comes back: the trolley flies and lands

struct Drop {
  double acceleration, time;  // of the floor, down and then up [g], of each [s]

  /// Relative to the floor the trolley rises with (a - g) for the time T and falls back with (a +
  /// g): it lands after T + t, (a + g) t^2 = (a - g) (T^2 + 2 T t).
  double fall() const {
    const double a = acceleration;
    return time * ((a - 1) + std::sqrt((a - 1) * (a - 1) + (a + 1) * (a - 1))) / (a + 1);
  }
};

constexpr double kSample = 1e-3, kStep = 1e-4, kStiff = 3e7;  // [s], [s], [N/m]

Findings fly(const Drop& drop, const Runner& runner) {
  Findings findings;
  const double a = drop.acceleration, T = kSample * std::round(drop.time / kSample);
  Scene scene;
  scene.items[0].model =
      small::trolley({0, 0, 180, 180}, small::bare_tread(kStiff, kStiff));  // it does not pitch
  const auto half = static_cast<Eigen::Index>(std::lround(T / kSample));
  Eigen::Matrix3Xd motion = Eigen::Matrix3Xd::Zero(3, 2 * half + 1);
  motion.row(2).head(half).setConstant(-a * kG);
  motion.row(2).tail(half).setConstant(a * kG);
  Excitation excitation;
  excitation.floor = {kSample, motion};
  const double t = Drop{a, T}.fall(), speed = ((a + 1) * t - (a - 1) * T) * kG;
  const Response response =
      runner(findings, scene, excitation, blocks::run_for(T + t + 0.02, kStep, kStep));
  double take_off = -1, landing = -1, approach = 0;
  for (const Sample& s : response.items[0].history) {
    const bool up = s.wheels[0].mode == WheelMode::kLifted;
    if (up && take_off < 0) take_off = s.time;
    if (up && landing < 0) approach = -s.velocity.z();
    if (!up && take_off >= 0 && landing < 0) landing = s.time;
  }
  // The treads hold the trolley until they are unloaded and throw it with their energy.
  const double omega = std::sqrt(4 * kStiff / whole_item(scene.items[0].model).mass);
  const double unload = std::acos((a - 1) / a) / omega;
  const double thrown = kG / omega * std::sqrt(a * a - (a - 1) * (a - 1));
  // Thrown so much faster, and so much later than the floor dropped; the samples of the record are
  // joined by lines between T - 1 ms and T.
  const double extra = std::abs(thrown - (a - 1) * kG * unload) + a * kG * kSample;
  const double late = extra * (T + t) / speed + 2 * kStep;
  const char* const terms =
      "the speed with which the treads throw it, g/omega sqrt(a^2 - (a - 1)^2), less the fall of "
      "the floor meanwhile, and a g 1 ms as the record's samples are joined by lines";
  auto& checks = findings.checks;
  checks.push_back(
      {"time at which it takes off", "s", take_off, unload, 2 * kStep, "two steps of 0.1 ms"});
  checks.push_back({"time at which it lands", "s", landing, T + t, late,
                    std::string("over the speed of landing, times the time: ") + terms});
  checks.push_back({"speed of the landing", "m/s", approach, speed, extra + late * (a + 1) * kG,
                    std::string("(a + 1) g times the tolerance of the time; ") + terms});
  checks.push_back({"wheels lifted", "",
                    static_cast<double>(response.items[0].demands.most_wheels_lifted), 4, 0,
                    "it flies"});
  checks.push_back({"closure of the energy account", "", response.quality.energy_closure, 0,
                    std::pow(omega * kStep, 2) / 4,
                    "(omega dt)^2 / 4 of the energy: the treads take up (omega dt)^2 of it in a "
                    "step; they touch in its middle, and half the depth stores a quarter"});
  return findings;
}

// --- elastic treads without friction give a wheel that meets a wall its speed back

struct Wall {
  double speed, swivels;  // [m/s], 0 or 1
};

Findings bounce(const Wall& c, const Runner& runner) {
  Findings findings;
  Scene scene;
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
  Excitation excitation;
  for (int dof : {2, 3, 4}) excitation.fixture.guides[dof] = {Guide::Kind::kHeld, 0, 0, 0};
  const Response response =
      runner(findings, scene, excitation, blocks::run_for(0.4 / c.speed, 0.004, 0.004));
  auto& checks = findings.checks;
  checks.push_back({"speed back", "m/s", -response.items[0].history.back().velocity.x(), c.speed,
                    2 * kImpactError * c.speed,
                    "4 (pi/32)^2 / 12 of the speed: 32 steps of a second-order method in half a "
                    "period of each of two treads, and as much for touch and end inside steps"});
  checks.push_back({"closure of the energy account", "", response.quality.energy_closure, 0,
                    4 * kImpactError, "twice that of the speed"});
  checks.push_back({"wheels that hit the wall", "", static_cast<double>(response.impacts.size()), 2,
                    0, "both front wheels, once"});
  return findings;
}

}  // namespace

Family flight() {
  return make_family<Drop>(
      {"flight", "vertical", "The floor drops away faster than gravity: a trolley flies and lands",
       "(a + g) t^2 = (a - g) (T^2 + 2 T t), v = (a + g) t - (a - g) T", "free fall"},
      {{{"acceleration", "g", 1.15, 1.9}, &Drop::acceleration},
       {{"time", "s", 0.06, 0.35}, &Drop::time}},
      {{"plain", {1.5, 0.1}}, {"long", {1.2, 0.3}}, {"strong", {1.8, 0.08}}}, fly);
}

Family wheel_at_wall() {
  return make_family<Wall>(
      {"wheel_at_wall", "impacts", "Elastic wheels without friction meet a wall", "v' = -v",
       "energy"},
      {{{"speed", "m/s", 0.2, 2.5}, &Wall::speed}, {{"swivels", "", 0, 1, true}, &Wall::swivels}},
      {{"slow", {0.3, 0}},
       {"plain", {1, 0}},
       {"fast", {2, 0}},
       {"slow_swivels", {0.3, 1}},
       {"plain_swivels", {1, 1}},
       {"fast_swivels", {2, 1}}},
      bounce);
}

}  // namespace gurney::verification
