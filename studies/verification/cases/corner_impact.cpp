#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/contact/impact_law.h"
#include "studies/verification/cases/sliding_block.h"
#include "studies/verification/family.h"
#include "studies/verification/scenes/blocks.h"
#include "studies/verification/scenes/planar_impact.h"

// A block that slides without friction meets something off its centre and turns. With the unit
// vector n from the wall into the block, the lever a of its line and the speed of approach v_n:
//
//     J = (1 + e) v_n / (1 / m + a^2 / I),  v' = v + (J / m) n,  yaw rate = (J / I) a
//
// at an instant. While it touches, the block turns and slides along, and the normal of a curve and
// the lever with it: scenes/planar_impact.h integrates that. Its limit for stiff contacts is the
// formula.
namespace gurney::verification {
namespace {

constexpr double kStiffness = 1e9;  // of each of two points, on top and at the bottom [N/m]
constexpr double kColumn = 0.15;    // radius [m]
const Vector3 kSize(0.5, 0.4, 0.6);

struct Motion {
  Vector2 velocity;
  double yaw_rate = 0;
};

struct Blow {
  SlidingBlock block;
  double restitution, speed;  // along x
  Vector2 point, normal;      // of the touch from the centre [m], into the block
  double yaw = 0;             // of the block
  bool front = false;         // its front meets a point, not an edge a plane or a curve
  double curve = 0;           // radius of what it meets [m]

  double lever() const { return point.x() * normal.y() - point.y() * normal.x(); }
  double effective_mass() const {
    return 1 / (1 / block.mass + lever() * lever() / block.yaw_inertia());
  }
  Motion after() const {
    const double impulse = -(1 + restitution) * speed * normal.x() * effective_mass();
    return {Vector2(speed, 0) + impulse / block.mass * normal,
            impulse * lever() / block.yaw_inertia()};
  }
  /// Two points, on top and at the bottom, with four on the floor.
  ImpactSteps steps() const {
    const Vector3 corner(point.x(), point.y(), 0.5 * block.size.z());
    const Vector3 direction(normal.x(), normal.y(), 0);
    return {effective_mass(), block.effective_mass(corner, direction), 2, 2 + kFloorPoints};
  }
  Motion integrated(double stiffness,
                    PlanarImpact::Contact contact = PlanarImpact::Contact::kFollows) const {
    const PlanarBody moving{1 / block.mass, 1 / block.yaw_inertia(), {0, 0}, {speed, 0}, yaw, 0};
    const PlanarBody standing{0, 0, point - curve * normal, {0, 0}, 0, 0};
    const double number = ImpactLaw::damping_number(restitution);
    const Vector2 on_block = Eigen::Rotation2Dd(-yaw) * point;
    if (front) {
      const PlanarSurfaces axis_to_face{{{0, 0}}, on_block, {1, 0}, curve};
      const PlanarImpact impact(standing, moving, axis_to_face, 2 * stiffness, number, contact);
      return {impact.after[1].velocity, impact.after[1].yaw_rate};
    }
    const PlanarSurfaces edge_to_wall{{on_block}, {0, 0}, normal, 0};
    const PlanarSurfaces edge_to_column{{on_block}, {0, 0}, {0, 0}, curve};
    const PlanarImpact impact(moving, standing, curve > 0 ? edge_to_column : edge_to_wall,
                              2 * stiffness, number, contact);
    return {impact.after[0].velocity, impact.after[0].yaw_rate};
  }
};

/// The formula is the limit of the integration: with a contact that is a million times stiffer it
/// turns and slides a thousandth as far.
void limit(const Blow& blow, Runner& runner) {
  const Motion formula = blow.after(), near = blow.integrated(kStiffness),
               limit = blow.integrated(1e6 * kStiffness);
  const double apart = (near.velocity - formula.velocity).norm();
  runner.check("velocity of the formula and of stiff springs", "m/s",
               (limit.velocity - formula.velocity).norm(),
               near_to(0, 2e-3 * apart + 1e-5 * blow.speed,
                       "twice a thousandth of what it differs by from springs of 1e9 N/m, as the "
                       "time of contact; 1e-5 of the speed for the integration"));
}

void compare(const Blow& blow, const Scene& scene, Runner& runner) {
  const ImpactSteps steps = blow.steps();
  const Response response = slide(runner, scene, 1.1 * kWayToImpact);
  const Motion exact = blow.integrated(kStiffness);
  limit(blow, runner);
  // The engine keeps point and normal for a step of 4 ms: those of the touch, and again others from
  // the next step on, each time for less than the whole impact.
  const Motion kept = blow.integrated(kStiffness, PlanarImpact::Contact::kStays);
  const double turning = blow.block.mass * blow.point.norm() / blow.block.yaw_inertia();
  const double apart = (kept.velocity - exact.velocity).norm();
  const double apart_yaw = std::max(std::abs(kept.yaw_rate - exact.yaw_rate), turning * apart);
  const double impulse = steps.speed_error() * blow.speed * blow.effective_mass();
  const double speed = impulse / blow.block.mass + 2 * apart;
  const double yaw_rate = impulse * std::abs(blow.lever()) / blow.block.yaw_inertia() +
                          2 * apart_yaw + 1e-9 * blow.speed;
  const char* const terms =
      "gamma^2 phi^2 of the impulse of an elastic impact, phi the phase of a step: where it "
      "touches and parts inside steps; twice what it changes, integrated, that point and normal of "
      "the contact stay those of the touch, of the yaw rate also m r / I times that; rounding, "
      "1e-9 of the speed";
  const Vector3& v = response.items[0].history.back().velocity;
  runner.check("velocity x after it", "m/s", v.x(), near_to(exact.velocity.x(), speed, terms));
  runner.check("velocity y after it", "m/s", v.y(), near_to(exact.velocity.y(), speed, terms));
  runner.check("yaw rate after it", "rad/s", yaw_rate_at_end(response),
               near_to(exact.yaw_rate, yaw_rate, terms));
}

/// Whether the front corners of the block are behind the plane x = 0 that it met with `point` when
/// the run ends, 0.1 of the way to the impact later, and it leaves faster than 0.02 m/s.
bool leaves(const Blow& blow, double yaw) {
  if (blow.restitution * -blow.normal.x() * blow.speed < 0.02) return false;
  const Motion after = blow.after();
  const double time = 0.1 * kWayToImpact / blow.speed;
  for (const double side : {-0.5, 0.5}) {
    const Vector2 corner = Eigen::Rotation2Dd(yaw + after.yaw_rate * time) *
                           Vector2(0.5 * kSize.x(), side * kSize.y());
    if (corner.x() + after.velocity.x() * time > blow.point.x() + 1e-4) return false;
  }
  return true;
}

// --- a vertical edge of the block against a wall

struct Edge {
  double yaw, restitution, speed, mass = 80;  // [rad], [-], [m/s], [kg]
  Blow blow() const {
    const Vector2 edge = Eigen::Rotation2Dd(yaw) *
                         Vector2(0.5 * kSize.x(), yaw > 0 ? -0.5 * kSize.y() : 0.5 * kSize.y());
    return {{mass, kSize}, restitution, speed, edge, {-1, 0}, yaw};
  }
};

void meet_wall(const Edge& c, Runner& runner) {
  const Blow blow = c.blow();
  Scene scene = blow.block.scene({c.speed, 0, 0});
  scene.items[0].initial.yaw = c.yaw;
  blocks::add_wall(scene, blow.point.x() + kWayToImpact,
                   {.stiffness = kStiffness, .restitution = c.restitution, .friction = 0});
  compare(blow, scene, runner);
}

bool edge_leaves(const Edge& c) { return leaves(c.blow(), c.yaw); }

// --- its front against a column, a wedge or the edge of a box

struct Obstacle {
  double kind, aside, restitution, speed, mass = 80;  // [-], [m], [-], [m/s], [kg]
  Blow blow() const {
    return {{mass, kSize}, restitution, speed, {0.5 * kSize.x(), aside},
            {-1, 0},       0,           true,  kind == 0 ? kColumn : 0};
  }
};

RoomShape obstacle(double kind, double aside) {
  const double front = 0.5 * kSize.x() + kWayToImpact;
  RoomShape shape{"obstacle", "plaster", {front, aside, 1.5}, Quaternion::Identity(), RoomBox{}};
  const Vector3 behind(kColumn, 0, 0);
  if (kind == 0) {
    shape.shape = RoomColumn{kColumn, 3};
    shape.position += behind;
  } else if (kind == 1) {
    RoomHull wedge;
    for (const double z : {-1.5, 1.5})
      for (const Vector2& p : {Vector2(0, 0), Vector2(0.2, 0.1), Vector2(0.2, -0.1)})
        wedge.points.emplace_back(p.x(), p.y(), z);
    shape.shape = wedge;
  } else {
    const double side = std::numbers::sqrt2 * kColumn;
    shape.shape = RoomBox{{side, side, 3}};
    shape.rotation = Quaternion(Eigen::AngleAxisd(std::numbers::pi / 4, Vector3::UnitZ()));
    shape.position += behind;
  }
  return shape;
}

void meet_obstacle(const Obstacle& c, Runner& runner) {
  const Blow blow = c.blow();
  Scene scene = blow.block.scene({c.speed, 0, 0});
  scene.room = {obstacle(c.kind, c.aside)};
  scene.pairs.push_back(
      {"steel", "plaster", {.stiffness = kStiffness, .restitution = c.restitution, .friction = 0}});
  compare(blow, scene, runner);
}

bool obstacle_leaves(const Obstacle& c) { return c.restitution * c.speed > 0.02; }

// --- a vertical edge of the block against the side of a column

struct Side {
  double aside, yaw, restitution, speed, mass = 80;  // [m], [rad], [-], [m/s], [kg]
  Blow blow() const {
    const Vector2 edge = Eigen::Rotation2Dd(yaw) * Vector2(0.5 * kSize.x(), -0.5 * kSize.y());
    const Vector2 normal(-std::sqrt(kColumn * kColumn - aside * aside), aside);
    return {{mass, kSize}, restitution, speed, edge, normal / kColumn, yaw, false, kColumn};
  }
};

void meet_column(const Side& c, Runner& runner) {
  const Blow blow = c.blow();
  Scene scene = blow.block.scene({c.speed, 0, 0});
  scene.items[0].initial.yaw = c.yaw;
  const Vector2 axis = blow.point + Vector2(kWayToImpact, 0) - kColumn * blow.normal;
  scene.room = {{"column",
                 "plaster",
                 {axis.x(), axis.y(), 1.5},
                 Quaternion::Identity(),
                 RoomColumn{kColumn, 3}}};
  scene.pairs.push_back(
      {"steel", "plaster", {.stiffness = kStiffness, .restitution = c.restitution, .friction = 0}});
  compare(blow, scene, runner);
}

/// The edge meets it, not a face: the faces at the edge look away from the normal.
bool edge_meets(const Side& c) {
  const Blow blow = c.blow();
  const double toward = std::atan2(-blow.normal.y(), -blow.normal.x());  // of the block's outline
  return toward < c.yaw - 0.05 && toward > c.yaw - std::numbers::pi / 2 + 0.05 &&
         leaves(blow, c.yaw);
}

const auto kSpeeds = cases(at("_slow", 0.2), at("", 0.8), at("_fast", 2));
const auto kRestitutions = cases(at("_soft", 0.2), at("", 0.5), at("_lively", 0.9));

constexpr const char* kSource = "angular momentum; Newton's law of restitution at the point";

}  // namespace

Family edge_impact() {
  return make_family<Edge>(
      {"edge_impact", "impacts", "A block meets a wall with a vertical edge",
       "J = (1 + e) v / (1/m + a^2/I), v' = v - J/m, yaw rate = J a / I", kSource},
      fields(FIELD(Edge, yaw, "rad", 0.1, 1.4), FIELD(Edge, restitution, "", 0.1, 1),
             FIELD(Edge, speed, "m/s", 0.2, 2.5), FIELD(Edge, mass, "kg", 20, 300)),
      combinations(
          {cases(at("slight", 0.2), at("turned", 0.4), at("far", 0.9)), kRestitutions, kSpeeds}),
      meet_wall, edge_leaves);
}

Family obstacle_impact() {
  return make_family<Obstacle>(
      {"obstacle_impact", "impacts",
       "A block meets a column (0), a wedge (1) or the edge of a box (2) with its front",
       "J = (1 + e) v / (1/m + y^2/I), v' = v - J/m, yaw rate = J y / I", kSource},
      fields(FIELD(Obstacle, kind, "", 0, 2, true), FIELD(Obstacle, aside, "m", -0.18, 0.18),
             FIELD(Obstacle, restitution, "", 0.1, 1), FIELD(Obstacle, speed, "m/s", 0.2, 2.5),
             FIELD(Obstacle, mass, "kg", 20, 300)),
      combinations({cases(at("column", 0), at("wedge", 1), at("box", 2)),
                    cases(at("", 0), at("_left", 0.1), at("_right", -0.15)), kRestitutions,
                    kSpeeds}),
      meet_obstacle, obstacle_leaves);
}

Family column_side() {
  return make_family<Side>(
      {"column_side", "impacts", "A vertical edge of a block meets a column beside its axis",
       "J = -(1 + e) v n_x / (1/m + a^2/I), v' = v + J/m n, yaw rate = J a / I", kSource},
      fields(FIELD(Side, aside, "m", -0.1, 0.1), FIELD(Side, yaw, "rad", 0.2, 1.3),
             FIELD(Side, restitution, "", 0.1, 1), FIELD(Side, speed, "m/s", 0.2, 2.5),
             FIELD(Side, mass, "kg", 20, 300)),
      combinations({cases(at("middle", 0, 0.7), at("left", 0.05, 0.7), at("right", -0.08, 0.7)),
                    kRestitutions, kSpeeds}),
      meet_column, edge_meets);
}

}  // namespace gurney::verification
