#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "studies/verification/cases/sliding_block.h"
#include "studies/verification/family.h"
#include "studies/verification/scenes/blocks.h"
#include "studies/verification/scenes/planar_impact.h"

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

/// The front against the points `across`: as fast as all of them on the inverse masses they meet.
ImpactSteps steps_of(const SlidingBlock& block, const std::vector<double>& across) {
  double inverse = 0;
  for (const double y : across) inverse += 1 / block.mass + y * y / block.yaw_inertia();
  const auto points = static_cast<double>(across.size());
  return {points / inverse, block.effective_mass(0.5 * kSize, Vector3::UnitX()), points,
          points + kFloorPoints};
}

/// Until it has parted, `contact` after the touch.
Response meet(const SlidingBlock& block, const Vector3& position, double roll, double speed,
              const ContactConstants& constants, double contact, Runner& runner) {
  Scene scene = block.scene({speed, 0, 0});
  for (int dof : {1, 2, 3, 4}) scene.items[0].fixture.guides[dof].kind = Guide::Kind::kHeld;
  blocks::add_wall(scene, 0, constants);
  RoomShape& wall = scene.room.back();
  wall.position = position + Vector3(0.5 * kSize.x() + 0.1 + kWayToImpact, 0, 0);
  wall.rotation = Quaternion(Eigen::AngleAxisd(roll, Vector3::UnitX()));
  return slide(runner, scene, 1.1 * kWayToImpact + 1.1 * contact * speed);
}

ContactConstants spring(double stiffness) {
  return {.kind = ContactConstants::Kind::kCompliant, .stiffness = stiffness, .friction = 0};
}

constexpr const char* kMethod =
    "gamma^2 phi^2 of the speed, phi the phase of a step: the points touch and part inside steps; "
    "twice what it changes that points where the wall ends stay on the block, integrated, of "
    "velocity or yaw rate times half the width; the square of the yaw in contact times length over "
    "width, the change of the levers";

/// Reference, and the engine's contact if the impact lies in a step of 4 ms, in
/// which points stay where they are on the block. In the next step they stay again elsewhere.
struct Springs {
  FaceContact exact, kept;
};

void compare(const std::string& law, const Springs& springs, double speed, const ImpactSteps& steps,
             const Response& response, Runner& runner) {
  const FaceContact &exact = springs.exact, &kept = springs.kept;
  const double arm = 0.5 * kSize.y();
  // Levers are held to first order of the yaw.
  const double turned = exact.yaw_rate[0] * speed * exact.contact * kSize.x() / kSize.y();
  const double method = steps.speed_error() + turned * turned;
  const double share = method + 2 * std::max(std::abs(kept.speed[0] - exact.speed[0]),
                                             arm * std::abs(kept.yaw_rate[0] - exact.yaw_rate[0]));
  const double peak =
      method + 2 * std::abs(kept.peak_force / exact.peak_force - 1) + std::pow(steps.phase, 2) / 8;
  runner.check("velocity after it, " + law, "m/s", response.items[0].history.back().velocity.x(),
               near_to(exact.speed[0] * speed, share * speed, kMethod));
  runner.check("yaw rate after it times half the width, " + law, "m/s",
               yaw_rate_at_end(response) * arm,
               near_to(exact.yaw_rate[0] * speed * arm, share * speed, kMethod));
  if (response.impacts.empty() || std::isnan(response.impacts[0].peak_force)) return;
  runner.check(
      "peak force", "N", response.impacts[0].peak_force,
      near_to(exact.peak_force * speed, peak * exact.peak_force * speed,
              std::string("of it: phi^2 / 8, a stage ends up to half a step off the peak; ") +
                  kMethod));
}

// --- the wall begins at y = start

struct Strip {
  double start, stiffness, speed, mass = 80;  // [m], [N/m], [m/s], [kg]
  SlidingBlock block() const { return {mass, kSize}; }
  std::vector<double> across() const { return {start, start, 0.5 * kSize.y(), 0.5 * kSize.y()}; }
  ImpactSteps steps() const { return steps_of(block(), across()); }
  FaceContact exact(bool kept = false) const {
    return against_wall(block(), across(), {!kept, !kept, false, false}, speed, stiffness);
  }
};

void meet_strip(const Strip& c, Runner& runner) {
  const FaceContact exact = c.exact();
  const Response response = meet(c.block(), {0, c.start + 1.5, 1.5}, 0, c.speed,
                                 spring(c.stiffness), exact.contact, runner);
  compare("springs", {exact, c.exact(true)}, c.speed, c.steps(), response, runner);
}

bool strip_parts(const Strip& c) {
  const FaceContact exact = c.exact();
  return exact.parts && exact.touches == 1;
}

// --- its lower edge runs at 45 degrees and leaves out the corner at y = -w/2, z = 0, by `cut`

struct Corner {
  double cut, stiffness, speed, restitution, mass = 80;  // [m], [N/m], [m/s], [-], [kg]
  SlidingBlock block() const { return {mass, kSize}; }
  std::vector<double> across() const {
    const double end = 0.5 * kSize.y();
    return {end, end, -end, -end, cut - end};
  }
  ImpactSteps steps() const { return steps_of(block(), across()); }
  FaceContact exact(double number, bool kept) const {
    return against_wall(block(), across(), {false, false, false, false, !kept}, speed, stiffness,
                        number);
  }
  Springs springs() const { return {exact(0, false), exact(0, true)}; }
  Springs restituted() const {
    const double number = FaceContact::damping_number(restitution);
    return {exact(number, false), exact(number, true)};
  }
};

void meet_corner(const Corner& c, Runner& runner) {
  const double roll = std::numbers::pi / 4;
  const Vector3 center =
      Vector3(0, c.cut - 0.5 * kSize.y(), 0) + 1.5 * Vector3(0, 1, 1).normalized();
  const auto met = [&](const std::string& law, const Springs& springs,
                       const ContactConstants& constants) {
    compare(law, springs, c.speed, c.steps(),
            meet(c.block(), center, roll, c.speed, constants, springs.exact.contact, runner),
            runner);
  };
  met("springs", c.springs(), spring(c.stiffness));
  met("restitution", c.restituted(),
      {.stiffness = c.stiffness, .restitution = c.restitution, .friction = 0});
}

bool corner_parts(const Corner& c) {
  const FaceContact springs = c.springs().exact, restituted = c.restituted().exact;
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
      fields(FIELD(Strip, start, "m", -0.15, 0.15), FIELD(Strip, stiffness, "N/m", 1e6, 1e8),
             FIELD(Strip, speed, "m/s", 0.2, 2), FIELD(Strip, mass, "kg", 20, 300)),
      cases(at("slow", 0.05, 1e8, 0.2), at("plain", 0.05, 1e8, 0.8), at("fast", 0.05, 1e8, 2),
            at("parts_by_turning", 0.03734, 8.378e7, 1.2844, 134.12)),
      meet_strip, strip_parts);
}

Family cut_corner() {
  return make_family<Corner>(
      {"cut_corner", "impacts", "A wall leaves out one corner of the block's front",
       "as partial_wall, at five corners; with restitution f = k d (1 + X d'/v)", kSource},
      fields(FIELD(Corner, cut, "m", 0.03, 0.35), FIELD(Corner, stiffness, "N/m", 1e6, 1e8),
             FIELD(Corner, speed, "m/s", 0.2, 2), FIELD(Corner, restitution, "", 0.1, 0.9),
             FIELD(Corner, mass, "kg", 20, 300)),
      cases(at("slow", 0.1, 1e7, 0.2, 0.2), at("plain", 0.1, 1e7, 0.8, 0.7),
            at("fast", 0.1, 1e7, 2, 0.2), at("soft", 0.347, 1e6, 1.77, 0.777, 298)),
      meet_corner, corner_parts);
}

}  // namespace gurney::verification
