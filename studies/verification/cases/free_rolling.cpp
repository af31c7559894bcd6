#include "engine/base/units.h"
#include "studies/verification/family.h"
#include "studies/verification/scenes/scenes.h"

namespace gurney::verification {
namespace {

using namespace scenes;

struct Roll {
  double speed, stiff, swivels;  // [m/s], treads, casters
  double mass = 96.5;
};

Findings roll(const Roll& c, const Runner& runner) {
  constexpr double kDuration = 60;
  Findings findings;
  ItemOptions options;
  options.total_mass = c.mass;
  Caster& caster = options.caster;
  if (c.stiff != 0) stiffen(caster.tread);
  caster.swivels = c.swivels != 0;
  caster.tread.rolling_friction_length = 0;
  caster.tread.tangential_damping = 100;  // above I_p v / trail^3: no flutter
  Scene scene = scene_of(trolley(options));
  scene.items[0].initial.velocity.x() = c.speed;
  const Response response = runner(findings, scene, {}, run_for(kDuration, 0.004, 1));
  const char* const why =
      "1e-9 of the speed: no sleeping, no drag; the solve's residual, 1e-9 g dt in each step, "
      "could add up to 6e-7 m/s but does not";
  Track velocity("velocity", "m/s", why), path("displacement", "m", why);
  Track across("displacement across", "m", "1e-9 m");
  for (const Sample& s : response.items[0].history) {
    velocity.add(s.time, s.velocity.x(), c.speed, 1e-9 * c.speed);
    path.add(s.time, s.displacement.x(), c.speed * s.time, 1e-9 * c.speed * kDuration);
    across.add(s.time, s.displacement.y(), 0, 1e-9);
  }
  velocity.report(findings);
  path.report(findings);
  across.report(findings);
  findings.checks.push_back(
      {"energy lost", "J", response.items[0].energy.loss(), 0, 1e-9, "1e-9 J"});
  return findings;
}

}  // namespace

Family free_rolling() {
  return make_family<Roll>(
      {"free_rolling", "conservation", "A trolley without resistance rolls on for a minute",
       "v = v0, x = v0 t, no loss", "Newton's first law"},
      {{{"speed", "m/s", 0.1, 3}, &Roll::speed},
       {{"stiff", "1 stiff treads", 0, 1, true}, &Roll::stiff},
       {{"swivels", "1 swivel casters", 0, 1, true}, &Roll::swivels},
       {{"mass", "kg", 40, 250}, &Roll::mass}},
      {{"slow_soft_rigid", {0.1, 0, 0}},
       {"slow_soft_swivel", {0.1, 0, 1}},
       {"slow_stiff_rigid", {0.1, 1, 0}},
       {"slow_stiff_swivel", {0.1, 1, 1}},
       {"soft_rigid", {1, 0, 0}},
       {"soft_swivel", {1, 0, 1}},
       {"stiff_rigid", {1, 1, 0}},
       {"stiff_swivel", {1, 1, 1}},
       {"fast_soft_rigid", {3, 0, 0}},
       {"fast_soft_swivel", {3, 0, 1}},
       {"fast_stiff_rigid", {3, 1, 0}},
       {"fast_stiff_swivel", {3, 1, 1}}},
      roll);
}

}  // namespace gurney::verification
