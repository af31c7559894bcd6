#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "studies/verification/cases.h"
#include "studies/verification/cases/sliding_block.h"
#include "studies/verification/scenes/blocks.h"
#include "studies/verification/scenes/face_contact.h"

// A wall that covers a part of the block's front only: the corners of the polygon that wall and
// front have in common are springs of the contact's stiffness each. Guides leave x and yaw free.
namespace gurney::verification {
namespace {

const Vector3 kSize(0.5, 0.4, 0.6);

/// The block against springs at `across` (y of points on its front) at `speed`, over the speed;
/// `of_wall`: those where the wall ends.
FaceContact against_wall(const SlidingBlock& block, const std::vector<double>& across,
                         const std::vector<bool>& of_wall, double speed, double stiffness,
                         double damping_number = 0) {
  return {{1 / block.mass, 1 / block.yaw_inertia(), 0},
          {},
          across,
          stiffness,
          damping_number,
          {0.5 * kSize.x() * speed, of_wall}};
}

/// Of the speed: the method, and the square of the change of levers, half the length over half the
/// width times the yaw in contact, which the reference holds to first order.
double error_of(const FaceContact& exact, double v) {
  const double turned = exact.yaw_rate[0] * v * exact.contact * kSize.x() / kSize.y();
  return kPhase * kPhase + turned * turned;
}

/// Until it has parted, `contact` after the touch.
Response meet(const SlidingBlock& block, const Vector3& position, double roll, double speed,
              const ContactConstants& constants, double contact, const Runner& runner,
              Findings& findings) {
  Scene scene = block.scene({speed, 0, 0});
  for (int dof : {1, 2, 3, 4}) scene.items[0].fixture.guides[dof].kind = Guide::Kind::kHeld;
  blocks::add_wall(scene, 0, constants);
  RoomShape& wall = scene.room.back();
  wall.position = position + Vector3(0.5 * kSize.x() + 0.1 + kWayToImpact, 0, 0);
  wall.rotation = Quaternion(Eigen::AngleAxisd(roll, Vector3::UnitX()));
  return slide(findings, runner, scene, 1.1 * kWayToImpact + 1.1 * contact * speed);
}

ContactConstants spring(double stiffness) {
  return {.kind = ContactConstants::Kind::kCompliant, .stiffness = stiffness, .friction = 0};
}

constexpr const char* kMethod =
    "phi^2 of the speed, phi = pi/32: 32 steps of a second-order method in half a period, while "
    "the points touch and part inside steps; the square of the yaw in contact times length over "
    "width, the change of the levers";

void compare(const std::string& law, const FaceContact& exact, double speed,
             const Response& response, Findings& findings) {
  const double share = error_of(exact, speed), arm = 0.5 * kSize.y();
  auto& checks = findings.checks;
  checks.push_back({"velocity after it, " + law, "m/s",
                    response.items[0].history.back().velocity.x(), exact.speed[0] * speed,
                    share * speed, kMethod});
  checks.push_back({"yaw rate after it times half the width, " + law, "m/s",
                    yaw_rate_at_end(response) * arm, exact.yaw_rate[0] * speed * arm, share * speed,
                    kMethod});
  if (response.impacts.empty() || std::isnan(response.impacts[0].peak_force)) return;
  checks.push_back({"peak force", "N", response.impacts[0].peak_force, exact.peak_force * speed,
                    share * exact.peak_force * speed,
                    std::string("of it: a stage ends up to half a step off the peak, ") + kMethod});
}

// --- the wall begins at y = start

struct Strip {
  double start, stiffness, speed, mass = 80;  // [m], [N/m], [m/s], [kg]
  SlidingBlock block() const { return {mass, kSize}; }
  FaceContact exact() const {
    const double end = 0.5 * kSize.y();
    return against_wall(block(), {start, start, end, end}, {true, true, false, false}, speed,
                        stiffness);
  }
};

Findings meet_strip(const Strip& c, const Runner& runner) {
  Findings findings;
  const FaceContact exact = c.exact();
  const Response response = meet(c.block(), {0, c.start + 1.5, 1.5}, 0, c.speed,
                                 spring(c.stiffness), exact.contact, runner, findings);
  compare("springs", exact, c.speed, response, findings);
  return findings;
}

bool strip_parts(const Strip& c) {
  const FaceContact exact = c.exact();
  return exact.parts && exact.touches == 1;
}

// --- its lower edge runs at 45 degrees and leaves out the corner at y = -w/2, z = 0, by `cut`

struct Corner {
  double cut, stiffness, speed, restitution, mass = 80;  // [m], [N/m], [m/s], [-], [kg]
  SlidingBlock block() const { return {mass, kSize}; }
  FaceContact exact(double stiffness_of, double number) const {
    const double end = 0.5 * kSize.y();
    return against_wall(block(), {end, end, -end, -end, cut - end},
                        {false, false, false, false, true}, speed, stiffness_of, number);
  }
  FaceContact springs() const { return exact(stiffness, 0); }
  FaceContact restituted() const {
    return exact(stiffness, FaceContact::damping_number(restitution));
  }
};

Findings meet_corner(const Corner& c, const Runner& runner) {
  Findings findings;
  const double roll = std::numbers::pi / 4;
  const Vector3 center =
      Vector3(0, c.cut - 0.5 * kSize.y(), 0) + 1.5 * Vector3(0, 1, 1).normalized();
  const auto met = [&](const std::string& law, const FaceContact& exact,
                       const ContactConstants& constants) {
    compare(law, exact, c.speed,
            meet(c.block(), center, roll, c.speed, constants, exact.contact, runner, findings),
            findings);
  };
  met("springs", c.springs(), spring(c.stiffness));
  met("restitution", c.restituted(),
      {.stiffness = c.stiffness, .restitution = c.restitution, .friction = 0});
  return findings;
}

bool corner_parts(const Corner& c) {
  const FaceContact springs = c.springs(), restituted = c.restituted();
  return springs.parts && springs.touches == 1 && restituted.parts && restituted.touches == 1 &&
         c.restitution * c.speed > 0.02;
}

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
      {{"slow", {0.05, 1e8, 0.2}},
       {"plain", {0.05, 1e8, 0.8}},
       {"fast", {0.05, 1e8, 2}},
       {"parts_by_turning", {0.03734, 8.378e7, 1.2844, 134.12}}},
      meet_strip, strip_parts);
}

Family cut_corner() {
  return make_family<Corner>(
      {"cut_corner", "impacts", "A wall leaves out one corner of the block's front",
       "as partial_wall, at five corners; with restitution f = k d (1 + X d'/v)", kSource},
      {{{"cut", "m", 0.03, 0.35}, &Corner::cut},
       {{"stiffness", "N/m", 1e6, 1e8}, &Corner::stiffness},
       {{"speed", "m/s", 0.2, 2}, &Corner::speed},
       {{"restitution", "", 0.1, 0.9}, &Corner::restitution},
       {{"mass", "kg", 20, 300}, &Corner::mass}},
      {{"slow", {0.1, 1e7, 0.2, 0.2}},
       {"plain", {0.1, 1e7, 0.8, 0.7}},
       {"fast", {0.1, 1e7, 2, 0.2}},
       {"soft", {0.347, 1e6, 1.77, 0.777, 298}}},
      meet_corner, corner_parts);
}

}  // namespace gurney::verification
