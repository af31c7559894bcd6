#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/units.h"
#include "engine/contact/impact_law.h"
#include "studies/verification/cases/sliding_block.h"
#include "studies/verification/family.h"
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

void meet(const Rebound& c, Runner& runner) {
  const SlidingBlock block{c.mass, {c.length, c.width, 0.6}};
  const double yaw = c.yaw * kRadiansPerDegree, v = c.speed;
  Scene scene = block.scene(turned(yaw, {v, 0, 0}));
  scene.items[0].initial.yaw = yaw;
  blocks::add_wall(scene, 0.5 * c.length + kWayToImpact,
                   {.restitution = c.restitution, .friction = 0});
  scene.room.back().rotation = Quaternion(Eigen::AngleAxisd(yaw, Vector3::UnitZ()));
  scene.room.back().position = turned(yaw, scene.room.back().position);
  const Response response = slide(runner, scene, 2 * kWayToImpact);
  const double share = c.restitution * block.front_steps().speed_error();
  const Vector3 after = turned(-yaw, response.items[0].history.back().velocity);
  const char* const phase =
      "e gamma^2 phi^2 of the speed: the kinks of the force where it touches and parts inside "
      "steps of the phase phi, pi/32 of a corner's mass on all points";
  const char* const residual = "1e-6 of the speed: what 1000 steps may leave, 1e-9 g dt each";
  runner.check("speed of the rebound", "m/s", -after.x(),
               near_to(c.restitution * v, share * v, phase));
  runner.check("speed along the wall", "m/s", after.y(), near_to(0, 1e-6 * v, residual));
  runner.check("yaw rate", "rad/s", yaw_rate_at_end(response), near_to(0, 1e-6, residual));
  if (response.impacts.empty()) return;
  const Impact& impact = response.impacts[0];
  runner.check("impulse", "N s", impact.impulse,
               near_to(c.mass * (1 + c.restitution) * v, share * c.mass * v,
                       std::string("the mass times ") + phase));
  runner.check("approach speed of the impact", "m/s", impact.approach_speed,
               near_to(v, 1e-6 * v, residual));
  const ContactConstants constants;
  const double stiffness = 4 * constants.stiffness * (1 + ImpactLaw::damping_number(c.restitution));
  runner.check("time of the impact", "s", impact.time,
               near_to(kWayToImpact / v, block.front_steps().phase * std::sqrt(c.mass / stiffness),
                       "the step in which it touches, phi sqrt(m / (4 k (1 + x)))"));
  runner.check("normal of the impact, along the wall's", "", turned(-yaw, impact.normal).x(),
               near_to(-1, 1e-9, "rounding"));
  // The block slides freely but for the wall: whatever accelerates it is numerical.
  const PointDemands& point = response.items[0].demands.points[0];
  runner.check("acceleration that is none of the impact, over that of it", "",
               point.peak_absolute_acceleration / point.numerical_acceleration,
               near_to(0, 1e-3, "one thousandth: all but the residual is the impact's"));
}

/// Contacts slower than 0.01 m/s cut no step.
bool parts(const Rebound& c) { return c.restitution * c.speed >= 2 * ImpactLaw::kLeastApproach; }

std::vector<Case> sets() {
  auto all =
      cases(at("dead", 0.05, 2.5, 0), at("elastic_slow", 1, 0.2, 30), at("elastic", 1, 2.5, 0));
  for (Case& each :
       combinations({cases(at("soft", 0.2), at("half", 0.5), at("lively", 0.7), at("hard", 0.9)),
                     cases(at("_slow", 0.2), at("", 0.8), at("_fast", 2)),
                     cases(at("", 0), at("_turned", 30), at("_back", -115))}))
    all.push_back(std::move(each));
  return all;
}

// --- a wall of stated stiffness and damping
//
// Where stiffness and damping of a contact are stated, the rebound follows. Four corners share the
// load; k is that of each.

struct Spring {
  double stiffness, damping, speed;  // [N/m], of critical, [m/s]
  double mass = 80;
};

void meet(const Spring& c, Runner& runner) {
  const SlidingBlock block{c.mass, {0.5, 0.4, 0.6}};
  const double omega = std::sqrt(4 * c.stiffness / c.mass), v = c.speed;
  Scene scene = block.scene({v, 0, 0});
  blocks::add_wall(scene, 0.5 * block.size.x() + kWayToImpact,
                   {.kind = ContactConstants::Kind::kCompliant,
                    .stiffness = c.stiffness,
                    .damping = 2 * c.damping * c.stiffness / omega,
                    .friction = 0});
  const CappedDamping exact(omega, c.damping);
  const ImpactSteps steps = block.front_steps();
  const double touch = kWayToImpact + v * exact.duration;  // path and time in contact
  const Response response = slide(runner, scene, touch + 0.5 * kWayToImpact);
  const PointDemands& point = response.items[0].demands.points[0];
  // With a damper the force has two kinks more, where its cap begins and ends.
  const double error = (c.damping > 0 ? 2 : 1) * steps.speed_error();
  runner.check(
      "speed of the rebound", "m/s", -response.items[0].history.back().velocity.x(),
      near_to(exact.restitution * v, error * v,
              "gamma^2 phi^2 of the speed, phi the phase of a step: half for each kink of the "
              "force, where it touches and parts, and with damping where the cap begins and ends"));
  if (response.impacts.empty()) return;
  const Impact& impact = response.impacts[0];
  runner.check("duration of the contact", "s", impact.duration,
               near_to(exact.duration, 1.5 * steps.phase / omega,
                       "half a step for the touch and one for the end, of phi sqrt(m / 4 k)"));
  const double peak = c.mass * v * exact.peak;
  // From zeta = 1/sqrt(8) on the force is largest where the cap ends, and rises with omega /
  // (2 zeta) of it until then.
  const bool pointed = 8 * c.damping * c.damping > 1;
  const auto share = [&](double apart) {
    const double phase = apart * steps.phase;
    return error + phase * phase / 2 + (pointed ? phase / (2 * c.damping) : 0);
  };
  const double force = share(0.5), acceleration = share(1);
  const char* const sampled =
      "of it that of the speed, and phi^2 / 2 for the phase phi by which it is sampled off the "
      "peak: half a step for the force, of two stages, and a step for the acceleration at its end; "
      "phi / (2 zeta) where the peak is a point, from zeta = 0.354 on";
  runner.check("peak force", "N", impact.peak_force, near_to(peak, force * peak, sampled));
  runner.check("peak acceleration", "m/s2", point.peak_absolute_acceleration,
               near_to(peak / c.mass, acceleration * peak / c.mass, sampled));
  runner.check("peak acceleration booked as an impact's", "m/s2", point.impact_acceleration,
               exactly(point.peak_absolute_acceleration, "the same number"));
  runner.check("peak force among the demands", "N", response.items[0].demands.peak_impact_force,
               exactly(impact.peak_force, "the same number"));
}

/// It parts faster than the 0.01 m/s below which no step is cut.
bool parts(const Spring& c) {
  return CappedDamping(std::sqrt(4 * c.stiffness / c.mass), c.damping).restitution * c.speed > 0.02;
}

// --- a rough wall
//
// A rough wall takes from the speed along it. Guides keep the block from turning, so all points
// slide alike, and slide on while the whole impulse of friction is less than the momentum.

struct Glance {
  double friction, restitution, along, speed = 0.8;  // speeds in m/s
  double mass = 80;

  double taken() const { return friction * (1 + restitution) * speed; }
};

void meet(const Glance& c, Runner& runner) {
  const SlidingBlock block{c.mass, {0.5, 0.4, 0.6}};
  Scene scene = block.scene({c.speed, c.along, 0});
  blocks::add_wall(scene, 0.5 * block.size.x() + kWayToImpact,
                   {.restitution = c.restitution, .friction = c.friction});
  for (int dof : {3, 4, 5}) scene.items[0].fixture.guides[dof].kind = Guide::Kind::kHeld;
  const ImpactSteps steps = block.front_steps();
  const double error = steps.speed_error();
  const double total = std::hypot(c.speed, c.along);
  const Response response = slide(runner, scene, 2 * kWayToImpact * total / c.speed);
  const Vector3& after = response.items[0].history.back().velocity;
  runner.check("speed of the rebound", "m/s", -after.x(),
               near_to(c.restitution * c.speed, c.restitution * error * c.speed,
                       "e gamma^2 phi^2 of the speed, phi the phase of a step: where the wall "
                       "touches and parts inside steps"));
  runner.check("speed that friction takes", "m/s", c.along - after.y(),
               near_to(c.taken(), c.friction * 2 * error * c.speed,
                       "mu times twice gamma^2 phi^2 of the speed, of the normal impulse"));
}

/// It slides from the touch on: the limit mu k (1 + x) v t grows slower than the tangential spring
/// would, 0.8 k v_t t; and to the end.
bool slides_on(const Glance& c) {
  const double touch = c.friction * (1 + ImpactLaw::damping_number(c.restitution)) * c.speed;
  const bool meets_wall = kWayToImpact / c.speed * c.along < 1;  // 3 m wide
  return touch < 0.8 * c.along && c.taken() < 0.8 * c.along && c.restitution * c.speed > 0.02 &&
         meets_wall;
}

}  // namespace

Family wall_rebound() {
  return make_family<Rebound>(
      {"wall_rebound", "impacts", "A block meets a wall with its face",
       "v' = -e v, J = (1 + e) m v, after the distance over the speed",
       "Newton's law of restitution; Hunt & Crossley 1975, J. Applied Mechanics 42"},
      fields(FIELD(Rebound, restitution, "", 0.05, 1), FIELD(Rebound, speed, "m/s", 0.1, 3),
             FIELD(Rebound, yaw, "deg", -180, 180), FIELD(Rebound, mass, "kg", 20, 300),
             FIELD(Rebound, length, "m", 0.2, 1), FIELD(Rebound, width, "m", 0.2, 1)),
      sets(), meet, parts);
}

Family wall_spring() {
  return make_family<Spring>(
      {"wall_spring", "impacts", "A block meets a wall of stated stiffness and damping",
       "undamped: touches for pi sqrt(m/k), F = v sqrt(k m); damped: k d + min(max(c d', -k d), k "
       "d)",
       "Newton's law for an oscillator"},
      fields(FIELD(Spring, stiffness, "N/m", 2e4, 5e6),
             FIELD(Spring, damping, "of critical", 0, 0.7), FIELD(Spring, speed, "m/s", 0.1, 3),
             FIELD(Spring, mass, "kg", 20, 300)),
      cases(at("soft_slow", 5e4, 0, 0.2), at("soft", 5e4, 0, 0.8), at("plain", 4e5, 0, 0.8),
            at("plain_fast", 4e5, 0, 2), at("stiff_slow", 2e6, 0, 0.2), at("stiff_fast", 2e6, 0, 2),
            at("damped_10", 2e5, 0.1, 1), at("damped_30", 2e5, 0.3, 1),
            at("damped_60", 2e5, 0.6, 1)),
      meet, parts);
}

Family wall_friction() {
  return make_family<Glance>(
      {"wall_friction", "impacts", "A block meets a rough wall at an angle and slides along it",
       "m (v_t - v_t') = mu (1 + e) m v_n", "Coulomb's law, integrated over the impact"},
      fields(FIELD(Glance, friction, "", 0.02, 0.8), FIELD(Glance, restitution, "", 0.1, 1),
             FIELD(Glance, along, "m/s", 0.1, 3), FIELD(Glance, speed, "m/s", 0.1, 3),
             FIELD(Glance, mass, "kg", 20, 300)),
      cases(at("smooth", 0.1, 0.2, 1.5), at("smooth_lively", 0.1, 0.7, 0.3),
            at("smooth_fast", 0.1, 0.7, 1.5), at("rough", 0.4, 0.2, 1.5),
            at("rough_lively", 0.4, 0.7, 1.5)),
      meet, slides_on);
}

}  // namespace gurney::verification
