#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "studies/verification/cases.h"
#include "studies/verification/cases/sliding_block.h"
#include "studies/verification/scenes/blocks.h"

// A block that slides without friction meets something off its centre and turns. With the unit
// vector n from the wall into the block, the lever a of its line and the speed of approach v_n:
//
//     J = (1 + e) v_n / (1 / m + a^2 / I),  v' = v + (J / m) n,  yaw rate = (J / I) a
namespace gurney::verification {
namespace {

constexpr double kStiffness = 1e9;  // of each of two points, on top and at the bottom [N/m]
constexpr double kColumn = 0.15;    // radius [m]
const Vector3 kSize(0.5, 0.4, 0.6);

struct Motion {
  Vector2 velocity;
  double yaw_rate = 0, impulse = 0;
};

struct Blow {
  SlidingBlock block;
  double restitution, speed;  // along x
  Vector2 point, normal;      // of the touch from the centre [m], into the block

  double lever() const { return point.x() * normal.y() - point.y() * normal.x(); }
  double effective_mass() const {
    return 1 / (1 / block.mass + lever() * lever() / block.yaw_inertia());
  }
  Motion after() const {
    const double impulse = -(1 + restitution) * speed * normal.x() * effective_mass();
    return {Vector2(speed, 0) + impulse / block.mass * normal,
            impulse * lever() / block.yaw_inertia(), impulse};
  }
  double longest_contact_time() const {
    return std::numbers::pi * std::sqrt(effective_mass() / (2 * kStiffness)) *
           longest_contact(restitution);
  }
};

/// What the block does while it touches: it turns, with the point on it, and slides along, which
/// turns the normal of a curve by the way over its radius. Momentum takes the mean over the
/// impulse, p(t) from 0 to 1: of the turn, yaw rate times the integral of p (1 - p) over the time
/// T, at most T / 4, and as much again for the speed of parting that the law of restitution sees;
/// of a way at constant v_t, v_t T / 2, as the force is largest in the first half.
struct Tolerance {
  double velocity = 0, yaw_rate = 0;
};
Tolerance tolerance_of(const Blow& blow, double curve) {
  const Motion exact = blow.after();
  const double time = blow.longest_contact_time();
  const Vector2 tangent(-blow.normal.y(), blow.normal.x());
  const double turn = std::abs(exact.yaw_rate) * time / 2;
  const double slip = std::abs(blow.speed * tangent.x()) * time / 2 + turn * blow.point.norm();
  Tolerance worst;
  for (const double sign : {-1.0, 1.0})
    for (const double side : {-1.0, 1.0}) {
      Blow other = blow;
      const double angle = sign * (turn + (curve > 0 ? slip / curve : 0));
      other.normal = Eigen::Rotation2Dd(angle) * blow.normal;
      other.point += side * (slip + turn * (blow.point.norm() + curve)) * tangent;
      const Motion moved = other.after();
      worst.velocity = std::max(worst.velocity, (moved.velocity - exact.velocity).norm());
      worst.yaw_rate = std::max(worst.yaw_rate, std::abs(moved.yaw_rate - exact.yaw_rate));
    }
  worst.velocity += kImpactError * blow.speed;
  worst.yaw_rate += kImpactError * std::abs(exact.yaw_rate) + 1e-9 * blow.speed;  // rounding
  return worst;
}

void compare(const Blow& blow, double curve, const Scene& scene, const Runner& runner,
             Findings& findings) {
  const Response response = slide(findings, runner, scene, 1.1 * kWayToImpact);
  const Motion exact = blow.after();
  const Tolerance tolerance = tolerance_of(blow, curve);
  const char* const terms =
      "how much the formula changes when normal and point move as far as they can, in the mean "
      "over the impulse: yaw rate T / 2 and v_t T / 2, T up to pi sqrt(m_eff / 2 k) (1 + e) / "
      "(2 sqrt(e)); 2 (pi/32)^2 / 12 of a method of "
      "second order with 32 steps in half a period";
  const Vector3& v = response.items[0].history.back().velocity;
  auto& checks = findings.checks;
  checks.push_back(
      {"velocity x after it", "m/s", v.x(), exact.velocity.x(), tolerance.velocity, terms});
  checks.push_back(
      {"velocity y after it", "m/s", v.y(), exact.velocity.y(), tolerance.velocity, terms});
  checks.push_back({"yaw rate after it", "rad/s", yaw_rate_at_end(response), exact.yaw_rate,
                    tolerance.yaw_rate, terms});
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
    return {{mass, kSize}, restitution, speed, edge, {-1, 0}};
  }
};

Findings meet_wall(const Edge& c, const Runner& runner) {
  Findings findings;
  const Blow blow = c.blow();
  Scene scene = blow.block.scene({c.speed, 0, 0});
  scene.items[0].initial.yaw = c.yaw;
  blocks::add_wall(scene, blow.point.x() + kWayToImpact,
                   {.stiffness = kStiffness, .restitution = c.restitution, .friction = 0});
  compare(blow, 0, scene, runner, findings);
  return findings;
}

bool edge_leaves(const Edge& c) { return leaves(c.blow(), c.yaw); }

// --- its front against a column, a wedge or the edge of a box

struct Obstacle {
  double kind, aside, restitution, speed, mass = 80;  // [-], [m], [-], [m/s], [kg]
  Blow blow() const {
    return {{mass, kSize}, restitution, speed, {0.5 * kSize.x(), aside}, {-1, 0}};
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

Findings meet_obstacle(const Obstacle& c, const Runner& runner) {
  Findings findings;
  const Blow blow = c.blow();
  Scene scene = blow.block.scene({c.speed, 0, 0});
  scene.room = {obstacle(c.kind, c.aside)};
  scene.pairs.push_back(
      {"steel", "plaster", {.stiffness = kStiffness, .restitution = c.restitution, .friction = 0}});
  compare(blow, 0, scene, runner, findings);
  return findings;
}

bool obstacle_leaves(const Obstacle& c) { return c.restitution * c.speed > 0.02; }

// --- a vertical edge of the block against the side of a column

struct Side {
  double aside, yaw, restitution, speed, mass = 80;  // [m], [rad], [-], [m/s], [kg]
  Blow blow() const {
    const Vector2 edge = Eigen::Rotation2Dd(yaw) * Vector2(0.5 * kSize.x(), -0.5 * kSize.y());
    const Vector2 normal(-std::sqrt(kColumn * kColumn - aside * aside), aside);
    return {{mass, kSize}, restitution, speed, edge, normal / kColumn};
  }
};

Findings meet_column(const Side& c, const Runner& runner) {
  Findings findings;
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
  compare(blow, kColumn, scene, runner, findings);
  return findings;
}

/// The edge meets it, not a face: the faces at the edge look away from the normal.
bool edge_meets(const Side& c) {
  const Blow blow = c.blow();
  const double toward = std::atan2(-blow.normal.y(), -blow.normal.x());  // of the block's outline
  return toward < c.yaw - 0.05 && toward > c.yaw - std::numbers::pi / 2 + 0.05 &&
         leaves(blow, c.yaw);
}

using Named = std::pair<const char*, double>;
constexpr Named kSpeeds[] = {{"_slow", 0.2}, {"", 0.8}, {"_fast", 2}};
constexpr Named kRestitutions[] = {{"_soft", 0.2}, {"", 0.5}, {"_lively", 0.9}};

std::vector<std::pair<std::string, Edge>> edges() {
  std::vector<std::pair<std::string, Edge>> all;
  for (const auto& [name, yaw] : {Named("slight", 0.2), {"turned", 0.4}, {"far", 0.9}})
    for (const auto& [kind, e] : kRestitutions)
      for (const auto& [pace, speed] : kSpeeds)
        all.push_back({std::string(name) + kind + pace, {yaw, e, speed}});
  return all;
}

std::vector<std::pair<std::string, Obstacle>> obstacles() {
  std::vector<std::pair<std::string, Obstacle>> all;
  for (const auto& [name, shape] : {Named("column", 0), {"wedge", 1}, {"box", 2}})
    for (const auto& [place, aside] : {Named("", 0), {"_left", 0.1}, {"_right", -0.15}})
      for (const auto& [kind, e] : kRestitutions)
        for (const auto& [pace, speed] : kSpeeds)
          all.push_back({std::string(name) + place + kind + pace, {shape, aside, e, speed}});
  return all;
}

std::vector<std::pair<std::string, Side>> sides() {
  std::vector<std::pair<std::string, Side>> all;
  for (const auto& [place, aside] : {Named("middle", 0), {"left", 0.05}, {"right", -0.08}})
    for (const auto& [kind, e] : kRestitutions)
      for (const auto& [pace, speed] : kSpeeds)
        all.push_back({std::string(place) + kind + pace, {aside, 0.7, e, speed}});
  return all;
}

constexpr const char* kSource = "angular momentum; Newton's law of restitution at the point";

}  // namespace

Family edge_impact() {
  return make_family<Edge>(
      {"edge_impact", "impacts", "A block meets a wall with a vertical edge",
       "J = (1 + e) v / (1/m + a^2/I), v' = v - J/m, yaw rate = J a / I", kSource},
      {{{"yaw", "rad", 0.1, 1.4}, &Edge::yaw},
       {{"restitution", "", 0.1, 1}, &Edge::restitution},
       {{"speed", "m/s", 0.2, 2.5}, &Edge::speed},
       {{"mass", "kg", 20, 300}, &Edge::mass}},
      edges(), meet_wall, edge_leaves);
}

Family obstacle_impact() {
  return make_family<Obstacle>(
      {"obstacle_impact", "impacts",
       "A block meets a column (0), a wedge (1) or the edge of a box (2) with its front",
       "J = (1 + e) v / (1/m + y^2/I), v' = v - J/m, yaw rate = J y / I", kSource},
      {{{"kind", "", 0, 2, true}, &Obstacle::kind},
       {{"aside", "m", -0.18, 0.18}, &Obstacle::aside},
       {{"restitution", "", 0.1, 1}, &Obstacle::restitution},
       {{"speed", "m/s", 0.2, 2.5}, &Obstacle::speed},
       {{"mass", "kg", 20, 300}, &Obstacle::mass}},
      obstacles(), meet_obstacle, obstacle_leaves);
}

Family column_side() {
  return make_family<Side>(
      {"column_side", "impacts", "A vertical edge of a block meets a column beside its axis",
       "J = -(1 + e) v n_x / (1/m + a^2/I), v' = v + J/m n, yaw rate = J a / I", kSource},
      {{{"aside", "m", -0.1, 0.1}, &Side::aside},
       {{"yaw", "rad", 0.2, 1.3}, &Side::yaw},
       {{"restitution", "", 0.1, 1}, &Side::restitution},
       {{"speed", "m/s", 0.2, 2.5}, &Side::speed},
       {{"mass", "kg", 20, 300}, &Side::mass}},
      sides(), meet_column, edge_meets);
}

}  // namespace gurney::verification
