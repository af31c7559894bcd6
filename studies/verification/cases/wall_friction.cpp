#include <cmath>

#include "engine/contact/impact_law.h"
#include "studies/verification/cases.h"
#include "studies/verification/cases/sliding_block.h"
#include "studies/verification/scenes/blocks.h"

// A rough wall takes from the speed along it. Guides keep the block from turning, so all points
// slide alike, and slide on while the whole impulse of friction is less than the momentum.
namespace gurney::verification {
namespace {

struct Glance {
  double friction, restitution, along, speed = 0.8;  // speeds in m/s
  double mass = 80;

  double taken() const { return friction * (1 + restitution) * speed; }
};

Findings meet(const Glance& c, const Runner& runner) {
  Findings findings;
  const SlidingBlock block{c.mass, {0.5, 0.4, 0.6}};
  Scene scene = block.scene({c.speed, c.along, 0});
  blocks::add_wall(scene, 0.5 * block.size.x() + kWayToImpact,
                   {.restitution = c.restitution, .friction = c.friction});
  for (int dof : {3, 4, 5}) scene.items[0].fixture.guides[dof].kind = Guide::Kind::kHeld;
  const ImpactSteps steps = block.front_steps();
  const double error = steps.speed_error();
  const double total = std::hypot(c.speed, c.along);
  const double work = (c.along * c.along - std::pow(c.along - c.taken(), 2)) / (total * total);
  const Response response =
      slide(findings, runner, scene, 2 * kWayToImpact * total / c.speed, steps, work);
  const Vector3& after = response.items[0].history.back().velocity;
  findings.checks.push_back(
      {"speed of the rebound", "m/s", -after.x(), c.restitution * c.speed,
       c.restitution * error * c.speed,
       "e gamma^2 phi^2 of the speed, phi the phase of a step: where the wall "
       "touches and parts inside steps"});
  findings.checks.push_back({"speed that friction takes", "m/s", c.along - after.y(), c.taken(),
                             c.friction * 2 * error * c.speed,
                             "mu times twice gamma^2 phi^2 of the speed, of the normal impulse"});
  return findings;
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

Family wall_friction() {
  return make_family<Glance>(
      {"wall_friction", "impacts", "A block meets a rough wall at an angle and slides along it",
       "m (v_t - v_t') = mu (1 + e) m v_n", "Coulomb's law, integrated over the impact"},
      {{{"friction", "", 0.02, 0.8}, &Glance::friction},
       {{"restitution", "", 0.1, 1}, &Glance::restitution},
       {{"along", "m/s", 0.1, 3}, &Glance::along},
       {{"speed", "m/s", 0.1, 3}, &Glance::speed},
       {{"mass", "kg", 20, 300}, &Glance::mass}},
      {{"smooth", {0.1, 0.2, 1.5}},
       {"smooth_lively", {0.1, 0.7, 0.3}},
       {"smooth_fast", {0.1, 0.7, 1.5}},
       {"rough", {0.4, 0.2, 1.5}},
       {"rough_lively", {0.4, 0.7, 1.5}}},
      meet, slides_on);
}

}  // namespace gurney::verification
