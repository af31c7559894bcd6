#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "studies/verification/cases.h"
#include "studies/verification/cases/sliding_block.h"
#include "studies/verification/scenes/blocks.h"

// A wall that covers a part of the block's front only: the corners of the polygon that wall and
// front have in common are springs of the contact's stiffness each. Guides leave x and yaw free.
namespace gurney::verification {
namespace {

const Vector3 kSize(0.5, 0.4, 0.6);

/// A block that meets springs at `across` (y of points on its front) at 1 m/s, by Runge-Kutta:
///     m x'' = -sum f,  I yaw'' = sum y f,  f = k max(0, x - y yaw)
struct Parted {
  double speed = 0, yaw_rate = 0, peak_force = 0;

  Parted(const SlidingBlock& block, const std::vector<double>& across, double stiffness) {
    const auto rates = [&](const Eigen::Vector4d& s) {  // x, yaw and their rates
      Eigen::Vector4d r(s[2], s[3], 0, 0);
      for (const double y : across) {
        const double force = stiffness * std::max(0.0, s[0] - y * s[1]);
        r[2] -= force / block.mass;
        r[3] += y * force / block.yaw_inertia();
      }
      return r;
    };
    Eigen::Vector4d s(0, 0, 1, 0);
    const double h = 1e-3 * std::sqrt(block.mass / stiffness);  // the slowest spring: one point
    for (int i = 0; i < 10000; ++i) {
      const Eigen::Vector4d a = rates(s), b = rates(s + 0.5 * h * a), c = rates(s + 0.5 * h * b);
      peak_force = std::max(peak_force, -block.mass * a[2]);
      s += h / 6 * (a + 2 * b + 2 * c + rates(s + h * c));
    }
    speed = s[2];
    yaw_rate = s[3];
  }
};

Response meet(const SlidingBlock& block, const Vector3& position, double roll, double speed,
              const ContactConstants& constants, const Runner& runner, Findings& findings) {
  Excitation excitation;
  for (int dof : {1, 2, 3, 4}) excitation.fixture.guides[dof].kind = Guide::Kind::kHeld;
  Scene scene = block.scene({speed, 0, 0});
  blocks::add_wall(scene, 0, constants);
  RoomShape& wall = scene.room.back();
  wall.position = position + Vector3(0.5 * kSize.x() + 0.1 + kWayToImpact, 0, 0);
  wall.rotation = Quaternion(Eigen::AngleAxisd(roll, Vector3::UnitX()));
  return slide(findings, runner, scene, 1.4 * kWayToImpact, excitation);
}

ContactConstants spring(double stiffness) {
  return {.kind = ContactConstants::Kind::kCompliant, .stiffness = stiffness, .friction = 0};
}

constexpr const char* kMethod =
    "phi^2 of the speed, phi = pi/32: 32 steps of a second-order method in half a period, while "
    "the points touch and part inside steps";

void compare(const SlidingBlock& block, const std::vector<double>& across, double stiffness,
             double speed, const Response& response, Findings& findings) {
  const Parted exact(block, across, stiffness);
  const double share = kPhase * kPhase, arm = 0.5 * kSize.y();
  auto& checks = findings.checks;
  checks.push_back({"velocity after it", "m/s", response.items[0].history.back().velocity.x(),
                    exact.speed * speed, share * speed, kMethod});
  checks.push_back({"yaw rate after it, times half the width", "m/s",
                    yaw_rate_at_end(response) * arm, exact.yaw_rate * speed * arm, share * speed,
                    kMethod});
  if (response.impacts.empty()) return;
  checks.push_back({"peak force", "N", response.impacts[0].peak_force, exact.peak_force * speed,
                    share * exact.peak_force * speed,
                    "phi^2 of it, phi = pi/32: a stage ends up to half a step off the peak"});
}

// --- the wall begins at y = start

struct Strip {
  double start, stiffness, speed, mass = 80;  // [m], [N/m], [m/s], [kg]
};

Findings meet_strip(const Strip& c, const Runner& runner) {
  Findings findings;
  const SlidingBlock block{c.mass, kSize};
  const Response response =
      meet(block, {0, c.start + 1.5, 1.5}, 0, c.speed, spring(c.stiffness), runner, findings);
  const double end = 0.5 * kSize.y();
  compare(block, {c.start, c.start, end, end}, c.stiffness, c.speed, response, findings);
  return findings;
}

// --- its lower edge runs at 45 degrees and leaves out the corner at y = -w/2, z = 0, by `cut`

struct Corner {
  double cut, stiffness, speed, restitution, mass = 80;  // [m], [N/m], [m/s], [-], [kg]
};

Findings meet_corner(const Corner& c, const Runner& runner) {
  Findings findings;
  const SlidingBlock block{c.mass, kSize};
  const double end = 0.5 * kSize.y(), roll = std::numbers::pi / 4;
  const Vector3 center = Vector3(0, c.cut - end, 0) + 1.5 * Vector3(0, 1, 1).normalized();
  compare(block, {end, end, -end, -end, c.cut - end}, c.stiffness, c.speed,
          meet(block, center, roll, c.speed, spring(c.stiffness), runner, findings), findings);
  const Response flat = meet(block, center, roll, c.speed,
                             {.restitution = c.restitution, .friction = 0}, runner, findings);
  // Every point rebounds with the restitution stated, wherever it is: the face stays flat.
  findings.checks.push_back({"speed of the rebound with restitution", "m/s",
                             -flat.items[0].history.back().velocity.x(), c.restitution * c.speed,
                             kPhase * kPhase * c.speed, kMethod});
  findings.checks.push_back({"yaw rate with restitution, times half the width", "m/s",
                             yaw_rate_at_end(flat) * end, 0, kPhase * kPhase * c.speed, kMethod});
  return findings;
}

bool corner_leaves(const Corner& c) { return c.restitution * c.speed > 0.02; }

constexpr const char* kSource = "Newton's law for springs at the corners in common, integrated";

}  // namespace

Family partial_wall() {
  return make_family<Strip>(
      {"partial_wall", "impacts", "A wall covers one side of the block's front, which turns",
       "m x'' = -sum f, I yaw'' = sum y f, f = k max(0, x - y yaw), at the corners in common",
       kSource},
      {{{"start", "m", -0.15, 0.15}, &Strip::start},
       {{"stiffness", "N/m", 1e6, 1e8}, &Strip::stiffness},
       {{"speed", "m/s", 0.2, 2}, &Strip::speed},
       {{"mass", "kg", 20, 300}, &Strip::mass}},
      {{"slow", {0.05, 1e8, 0.2}}, {"plain", {0.05, 1e8, 0.8}}, {"fast", {0.05, 1e8, 2}}},
      meet_strip);
}

Family cut_corner() {
  return make_family<Corner>(
      {"cut_corner", "impacts", "A wall leaves out one corner of the block's front",
       "as partial_wall, at five corners; restitution e at every one: v' = -e v", kSource},
      {{{"cut", "m", 0.03, 0.35}, &Corner::cut},
       {{"stiffness", "N/m", 1e6, 1e8}, &Corner::stiffness},
       {{"speed", "m/s", 0.2, 2}, &Corner::speed},
       {{"restitution", "", 0.1, 0.9}, &Corner::restitution},
       {{"mass", "kg", 20, 300}, &Corner::mass}},
      {{"slow", {0.1, 1e7, 0.2, 0.2}},
       {"plain", {0.1, 1e7, 0.8, 0.7}},
       {"fast", {0.1, 1e7, 2, 0.2}}},
      meet_corner, corner_leaves);
}

}  // namespace gurney::verification
