#include <cmath>
#include <numbers>

#include "studies/verification/cases.h"
#include "studies/verification/cases/sliding_block.h"
#include "studies/verification/scenes/blocks.h"

// Where stiffness and damping of a contact are stated, the rebound follows. Four corners share the
// load; k is that of each.
namespace gurney::verification {
namespace {

struct Spring {
  double stiffness, damping, speed;  // [N/m], of critical, [m/s]
  double mass = 80;
};

Findings meet(const Spring& c, const Runner& runner) {
  Findings findings;
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
  const Response response = slide(findings, runner, scene, touch + 0.5 * kWayToImpact, steps);
  const PointDemands& point = response.items[0].demands.points[0];
  // With a damper the force has two kinks more, where its cap begins and ends.
  const double error = (c.damping > 0 ? 2 : 1) * steps.speed_error();
  auto& checks = findings.checks;
  checks.push_back({"speed of the rebound", "m/s", -response.items[0].history.back().velocity.x(),
                    exact.restitution * v, error * v,
                    "gamma^2 phi^2 of the speed, phi the phase of a step: half for each kink of "
                    "the force, where it touches and parts, and with damping where the cap begins "
                    "and ends"});
  if (response.impacts.empty()) return findings;
  const Impact& impact = response.impacts[0];
  checks.push_back({"duration of the contact", "s", impact.duration, exact.duration,
                    1.5 * steps.phase / omega,
                    "half a step for the touch and one for the end, of phi sqrt(m / 4 k)"});
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
      "peak: half a step for the force, of two stages, and a step for the acceleration at its "
      "end; phi / (2 zeta) where the peak is a point, from zeta = 0.354 on";
  checks.push_back({"peak force", "N", impact.peak_force, peak, force * peak, sampled});
  checks.push_back({"peak acceleration", "m/s2", point.peak_absolute_acceleration, peak / c.mass,
                    acceleration * peak / c.mass, sampled});
  checks.push_back({"peak acceleration booked as an impact's", "m/s2", point.impact_acceleration,
                    point.peak_absolute_acceleration, 0, "the same number"});
  checks.push_back({"peak force among the demands", "N",
                    response.items[0].demands.peak_impact_force, impact.peak_force, 0,
                    "the same number"});
  return findings;
}

/// It parts faster than the 0.01 m/s below which no step is cut.
bool parts(const Spring& c) {
  return CappedDamping(std::sqrt(4 * c.stiffness / c.mass), c.damping).restitution * c.speed > 0.02;
}

}  // namespace

Family wall_spring() {
  return make_family<Spring>(
      {"wall_spring", "impacts", "A block meets a wall of stated stiffness and damping",
       "undamped: touches for pi sqrt(m/k), F = v sqrt(k m); damped: k d + min(max(c d', -k d), k "
       "d)",
       "Newton's law for an oscillator"},
      {{{"stiffness", "N/m", 2e4, 5e6}, &Spring::stiffness},
       {{"damping", "of critical", 0, 0.7}, &Spring::damping},
       {{"speed", "m/s", 0.1, 3}, &Spring::speed},
       {{"mass", "kg", 20, 300}, &Spring::mass}},
      {{"soft_slow", {5e4, 0, 0.2}},
       {"soft", {5e4, 0, 0.8}},
       {"plain", {4e5, 0, 0.8}},
       {"plain_fast", {4e5, 0, 2}},
       {"stiff_slow", {2e6, 0, 0.2}},
       {"stiff_fast", {2e6, 0, 2}},
       {"damped_10", {2e5, 0.1, 1}},
       {"damped_30", {2e5, 0.3, 1}},
       {"damped_60", {2e5, 0.6, 1}}},
      meet, parts);
}

}  // namespace gurney::verification
