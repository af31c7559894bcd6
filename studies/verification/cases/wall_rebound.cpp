#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/units.h"
#include "engine/contact/impact_law.h"
#include "studies/verification/cases.h"
#include "studies/verification/cases/sliding_block.h"
#include "studies/verification/scenes/blocks.h"

// The face of a block meets a wall: all four corners at once, so it does not turn.
namespace gurney::verification {
namespace {

struct Rebound {
  double restitution, speed, yaw;  // [-], [m/s], of wall and block [deg]
  double mass = 80, length = 0.5, width = 0.4;
};

Vector3 turned(double yaw, const Vector3& v) {
  return Eigen::AngleAxisd(yaw, Vector3::UnitZ()) * v;
}

Findings meet(const Rebound& c, const Runner& runner) {
  Findings findings;
  const SlidingBlock block{c.mass, {c.length, c.width, 0.6}};
  const double yaw = c.yaw * kRadiansPerDegree, v = c.speed;
  Scene scene = block.scene(turned(yaw, {v, 0, 0}));
  scene.items[0].initial.yaw = yaw;
  blocks::add_wall(scene, 0.5 * c.length + kWayToImpact,
                   {.restitution = c.restitution, .friction = 0});
  scene.room.back().rotation = Quaternion(Eigen::AngleAxisd(yaw, Vector3::UnitZ()));
  scene.room.back().position = turned(yaw, scene.room.back().position);
  const Response response = slide(findings, runner, scene, 2 * kWayToImpact, block.front_steps());
  const double share = c.restitution * block.front_steps().speed_error();
  const Vector3 after = turned(-yaw, response.items[0].history.back().velocity);
  const char* const phase =
      "e gamma^2 phi^2 of the speed: the kinks of the force where it touches and parts inside "
      "steps "
      "of the phase phi, pi/32 of a corner's mass on all points";
  const char* const residual = "1e-6 of the speed: what 1000 steps may leave, 1e-9 g dt each";
  auto& checks = findings.checks;
  checks.push_back(
      {"speed of the rebound", "m/s", -after.x(), c.restitution * v, share * v, phase});
  checks.push_back({"speed along the wall", "m/s", after.y(), 0, 1e-6 * v, residual});
  checks.push_back({"yaw rate", "rad/s", yaw_rate_at_end(response), 0, 1e-6, residual});
  if (response.impacts.empty()) return findings;
  const Impact& impact = response.impacts[0];
  checks.push_back({"impulse", "N s", impact.impulse, c.mass * (1 + c.restitution) * v,
                    share * c.mass * v, std::string("the mass times ") + phase});
  checks.push_back(
      {"approach speed of the impact", "m/s", impact.approach_speed, v, 1e-6 * v, residual});
  const ContactConstants constants;
  const double stiffness = 4 * constants.stiffness * (1 + ImpactLaw::damping_number(c.restitution));
  checks.push_back({"time of the impact", "s", impact.time, kWayToImpact / v,
                    block.front_steps().phase * std::sqrt(c.mass / stiffness),
                    "the step in which it touches, phi sqrt(m / (4 k (1 + x)))"});
  checks.push_back({"normal of the impact, along the wall's", "", turned(-yaw, impact.normal).x(),
                    -1, 1e-9, "rounding"});
  // The block slides freely but for the wall: whatever accelerates it is numerical.
  const PointDemands& point = response.items[0].demands.points[0];
  checks.push_back({"acceleration that is none of the impact, over that of it", "",
                    point.peak_absolute_acceleration / point.numerical_acceleration, 0, 1e-3,
                    "one thousandth: all but the residual is the impact's"});
  return findings;
}

/// Contacts slower than 0.01 m/s cut no step.
bool parts(const Rebound& c) { return c.restitution * c.speed >= 2 * ImpactLaw::kLeastApproach; }

std::vector<std::pair<std::string, Rebound>> sets() {
  std::vector<std::pair<std::string, Rebound>> all{
      {"dead", {0.05, 2.5, 0}}, {"elastic_slow", {1, 0.2, 30}}, {"elastic", {1, 2.5, 0}}};
  for (const auto& [kind, e] :
       {std::pair("soft", 0.2), {"half", 0.5}, {"lively", 0.7}, {"hard", 0.9}})
    for (const auto& [pace, speed] : {std::pair("_slow", 0.2), {"", 0.8}, {"_fast", 2.0}})
      for (const auto& [direction, yaw] :
           {std::pair("", 0.0), {"_turned", 30.0}, {"_back", -115.0}})
        all.push_back({std::string(kind) + pace + direction, {e, speed, yaw}});
  return all;
}

}  // namespace

Family wall_rebound() {
  return make_family<Rebound>(
      {"wall_rebound", "impacts", "A block meets a wall with its face",
       "v' = -e v, J = (1 + e) m v, after the distance over the speed",
       "Newton's law of restitution; Hunt & Crossley 1975, J. Applied Mechanics 42"},
      {{{"restitution", "", 0.05, 1}, &Rebound::restitution},
       {{"speed", "m/s", 0.1, 3}, &Rebound::speed},
       {{"yaw", "deg", -180, 180}, &Rebound::yaw},
       {{"mass", "kg", 20, 300}, &Rebound::mass},
       {{"length", "m", 0.2, 1}, &Rebound::length},
       {{"width", "m", 0.2, 1}, &Rebound::width}},
      sets(), meet, parts);
}

}  // namespace gurney::verification
