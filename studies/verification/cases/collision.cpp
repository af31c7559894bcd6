#include <algorithm>
#include <cmath>

#include "engine/base/units.h"
#include "engine/contact/impact_law.h"
#include "studies/verification/cases/sliding_block.h"
#include "studies/verification/family.h"
#include "studies/verification/scenes/blocks.h"
#include "studies/verification/scenes/planar_impact.h"

// A block that slides along x without friction into another one that stands.
namespace gurney::verification {
namespace {

constexpr double kStep = 0.004, kGap = 0.1;  // [s], [m]
const Vector3 kFirst(0.5, 0.4, 0.6), kSecond(0.3, 0.3, 0.6);

/// The second block's middle is `aside` of the first one's path, its face 0.1 m before it.
Scene two_blocks(double first, double second, double speed, double aside,
                 const ContactConstants& constants) {
  Scene scene = blocks::block(first, kFirst, {.friction = 0});
  scene.items.push_back(blocks::block(second, kSecond, {.friction = 0}).items[0]);
  scene.items[0].name = "first";
  scene.items[1].name = "second";
  scene.items[0].initial.velocity = {speed, 0, 0};
  scene.items[1].initial.position = {0.5 * (kFirst.x() + kSecond.x()) + kGap, aside, 0};
  scene.pairs.push_back({"steel", "steel", constants});
  return scene;
}

double speed_at_end(const Response& response, std::size_t item) {
  return response.items[item].history.back().points[0].velocity.x();
}

struct Collision {
  double restitution, second, speed = 0.8, first = 80, aside = 0;  // [-], [kg], [m/s], [kg], [m]
  double stiffness = ContactConstants().stiffness;                 // of a corner [N/m]

  /// The corners of the second block's face, which lies within the first one's.
  PlanarImpact exact(PlanarImpact::Contact contact = PlanarImpact::Contact::kFollows) const {
    const Vector2 corner = -0.5 * kSecond.head<2>();
    const Vector2 other(corner.x(), -corner.y());
    return {{1 / second,
             1 / solid_box_inertia(second, kSecond)(2, 2),
             {0.5 * (kFirst.x() + kSecond.x()), aside},
             {0, 0},
             0,
             0},
            {1 / first, 1 / solid_box_inertia(first, kFirst)(2, 2), {0, 0}, {speed, 0}, 0, 0},
            {{corner, corner, other, other}, {0.5 * kFirst.x(), 0}, {1, 0}, 0},
            stiffness,
            ImpactLaw::damping_number(restitution),
            contact};
  }
  ImpactSteps steps() const {
    const Vector3 x = Vector3::UnitX();
    const Vector3 here(0.5 * kFirst.x(), std::abs(aside) + 0.5 * kSecond.y(), 0.5 * kFirst.z());
    const double at_first = SlidingBlock{first, kFirst}.effective_mass(here, x);
    const double at_second = SlidingBlock{second, kSecond}.effective_mass(0.5 * kSecond, x);
    // The engine counts the points of the item that has more.
    return {1 / (1 / first + 1 / second), 1 / (1 / at_first + 1 / at_second), 4, 4 + kFloorPoints};
  }
};

void collide(const Collision& c, Runner& runner) {
  const double v = c.speed, M = c.first, m = c.second, e = c.restitution;
  const PlanarImpact exact = c.exact();
  const Response response = runner(
      two_blocks(M, m, v, c.aside, {.stiffness = c.stiffness, .restitution = e, .friction = 0}), {},
      blocks::run_for(1.2 * kGap / v + exact.duration, kStep, kStep));
  const double a = speed_at_end(response, 0), b = speed_at_end(response, 1);
  const double effective = 1 / (1 / M + 1 / m);
  const ImpactSteps steps = c.steps();
  const double share = steps.speed_error();
  // The engine keeps points and normal for a step of 4 ms: those of the touch, and again others
  // from the next step on, each time for less than the whole impact.
  const PlanarImpact kept = c.exact(PlanarImpact::Contact::kStays);
  const auto stays = [&](std::size_t body) {
    const PlanarBody &stay = kept.after[body], &follow = exact.after[body];
    return 2 * std::max((stay.velocity - follow.velocity).norm(),
                        0.5 * kSecond.y() * std::abs(stay.yaw_rate - follow.yaw_rate));
  };
  const char* const terms =
      "gamma^2 phi^2 of the speed, phi the phase of a step: where they touch and part inside "
      "steps; twice what it changes, integrated, that points and normal of the contact stay those "
      "of the touch, of velocity or yaw rate times half the width";
  const Vector2 &after_first = exact.after[1].velocity, &after_second = exact.after[0].velocity;
  runner.check("momentum of the second block", "N s", m * b,
               near_to(m * after_second.x(), share * v * effective + m * stays(0),
                       std::string("the reduced mass times ") + terms));
  runner.check("momentum of both", "N s", M * a + m * b,
               near_to(M * v, 1e-9 * (M + m) * kStandardGravity * (1.2 * kGap / v + exact.duration),
                       "residual of the solve, 1e-9 (M + m) g t"));
  runner.check("speed of parting", "m/s", b - a,
               near_to(after_second.x() - after_first.x(), share * v + stays(0) + stays(1), terms));
  for (const std::size_t i : {0, 1})
    runner.check(
        i == 0 ? "yaw rate of the first block times half the width"
               : "yaw rate of the second block times half the width",
        "m/s", yaw_rate_at_end(response, i) * 0.5 * kSecond.y(),
        near_to(exact.after[1 - i].yaw_rate * 0.5 * kSecond.y(), share * v + stays(1 - i), terms));
  runner.check("energy balance error", "", response.quality.energy_closure,
               closes_over(1.2 * kGap / v + exact.duration, v));
  if (c.aside == 0)
    runner.check("impulse", "N s", m * b,
                 near_to((1 + e) * v * effective, share * v * effective,
                         std::string("the reduced mass times ") + terms));
  if (response.impacts.empty()) {
    runner.check("impacts", "", 0, exactly(1, "they meet"));
  }
  const Impact& impact = response.impacts[0];
  const double turn =
      (std::abs(exact.after[0].yaw_rate) + std::abs(exact.after[1].yaw_rate)) * exact.duration;
  runner.check("impulse stated of the impact", "N s", impact.impulse,
               near_to(m * b, (1e-6 + turn * turn) * m * b,
                       "1e-6 of it, the second block has no other, and the square of the yaws in "
                       "contact, the cosine of its direction"));
  runner.check("approach speed of the impact", "m/s", impact.approach_speed,
               near_to(v, 1e-6 * v, "what 1000 steps may leave, 1e-9 g dt each"));
  runner.check("normal of the impact", "", impact.normal.x(),
               near_to(-1, 1e-9, "they meet unturned: rounding"));
}

bool parts(const Collision& c) {
  const PlanarImpact exact = c.exact();
  return c.restitution * c.speed > 2 * ImpactLaw::kLeastApproach && exact.parted &&
         exact.touches == 1;
}

// --- a push on the first of two blocks before a wall goes through both

struct Row {
  double push, stiffness, first = 80, second = 20;  // [N], [N/m], [kg], [kg]
};

/// At rest each pair of faces, four corners of stiffness k, is pressed together by F / (4 k).
void press(const Row& c, Runner& runner) {
  constexpr double kSlit = 1e-3, kTime = 3;
  Scene scene = two_blocks(c.first, c.second, 0, 0,
                           {.stiffness = c.stiffness, .restitution = 0.3, .friction = 0});
  scene.items[1].initial.position.x() = 0.5 * kFirst.x() + kSlit + 0.5 * kSecond.x();
  blocks::add_wall(scene, 0.5 * kFirst.x() + kSlit + kSecond.x() + kSlit,
                   {.stiffness = c.stiffness, .friction = 0});
  scene.items[0].loads = {
      PointForce{"push", {0, 0, 0.5 * kFirst.z()}, {1, 0, 0}, {0, 10}, {c.push, c.push}}};
  const Response response = runner(scene, {}, blocks::run_for(kTime, kStep, 0.1));
  const double pressed = c.push / (4 * c.stiffness);
  const Sample &first = response.items[0].history.back(),
               &second = response.items[1].history.back();
  const char* const residual = "what an oscillation below the resolved 0.01 m/s leaves: 0.2 %";
  runner.check("displacement of the second block", "m", second.displacement.x(),
               near_to(kSlit + pressed, 0.002 * pressed, residual));
  runner.check("displacement of the first block", "m", first.displacement.x(),
               near_to(2 * kSlit + 2 * pressed, 0.004 * pressed, residual));
  runner.check("speed at the end", "m/s", first.velocity.norm(), near_to(0, 1e-6, "at rest"));
  runner.check("steps that were divided", "", response.quality.subdivided_steps,
               exactly(0, "Newton's method knows how the items push each other"));
  runner.check("iterations in a step", "",
               static_cast<double>(response.quality.newton_iterations) /
                   static_cast<double>(response.quality.steps),
               near_to(0, 6,
                       "two stages, settled by a matrix of an earlier one in at most three "
                       "iterations each when nothing changes, none where it rests"));
}

}  // namespace

Family collision() {
  return make_family<Collision>(
      {"collision", "impacts", "A block slides into another one, in the middle or aside of it",
       "J = (1 + e) v / (1/M + 1/m) in the middle; aside, f = k d (1 + X d'/v) at the corners",
       "Newton's laws, of motion and of restitution; Hunt & Crossley 1975"},
      fields(FIELD(Collision, restitution, "", 0.1, 1), FIELD(Collision, second, "kg", 10, 300),
             FIELD(Collision, speed, "m/s", 0.2, 2), FIELD(Collision, first, "kg", 20, 300),
             FIELD(Collision, aside, "m", -0.045, 0.045),
             FIELD(Collision, stiffness, "N/m", 1e6, 1e8)),
      cases(at("light_soft", 0.2, 20), at("light", 0.7, 20), at("light_elastic", 1, 20),
            at("equal_soft", 0.2, 80), at("equal", 0.7, 80), at("equal_elastic", 1, 80),
            at("heavy_soft", 0.2, 200), at("heavy", 0.7, 200), at("heavy_elastic", 1, 200),
            at("aside", 0.5, 20, 0.8, 80, 0.04)),
      collide, parts);
}

Family pressed_row() {
  return make_family<Row>(
      {"pressed_row", "impacts", "A push presses two blocks in a row against a wall",
       "each pair of faces deflects by F / (4 k)", "statics of springs"},
      fields(FIELD(Row, push, "N", 50, 500), FIELD(Row, stiffness, "N/m", 2e5, 5e6),
             FIELD(Row, first, "kg", 20, 200), FIELD(Row, second, "kg", 20, 200)),
      cases(at("plain", 200, 1e6)), press);
}

}  // namespace gurney::verification
