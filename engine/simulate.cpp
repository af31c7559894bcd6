#include "engine/simulate.h"

#include "engine/bullet/bullet_world.h"
#include "engine/bullet/stock_baseline.h"
#include "engine/recorder.h"
#include "engine/run_clock.h"
#include "engine/solver/equilibrium.h"
#include "engine/solver/mechanism.h"
#include "engine/solver/stepper.h"

namespace gurney {
namespace {

Response simulate_with_star(const Scene& scene, const Excitation& excitation,
                            const SimulationSettings& settings) {
  const Mechanism mechanism(scene, excitation);
  State state = mechanism.placed(scene.initial);
  settle(mechanism, scene, excitation, state);
  mechanism.set_in_motion(scene.initial, state);

  Stepper stepper(mechanism, excitation.floor, settings);
  BulletWorld world(scene, mechanism, settings.skip_clear_collision_passes);
  Recorder recorder(scene, mechanism, state);
  RunClock clock(excitation, mechanism.loads.breakpoints(), settings);
  const Stepper::Observer observer = [&](const Stepper::Step& step) { recorder.observe(step); };
  std::optional<std::string> cause;
  const BulletWorld::Solve solve = [&](double, const std::vector<BodyContact>& contacts) {
    stepper.set_contacts(contacts, state);
    cause = stepper.advance(state, clock.target(), observer);
  };

  recorder.sample(state, stepper.account(), clock.keeps_history());
  double sampled_at = state.time;
  while (clock.next(state.time)) {
    world.step(clock.target() - state.time, state, solve);
    if (cause) {
      clock.stop(Outcome::kDiverged, *cause);
      break;
    }
    if (clock.at_breakpoint()) stepper.change_loads(state);
    if (clock.sample_due()) {
      recorder.sample(state, stepper.account(), clock.keeps_history());
      sampled_at = state.time;
    }
    const bool fallen = clock.overturned_at() >= 0;
    clock.observe(state.time, fallen ? recorder.body_speed() : recorder.speed(), recorder.tilt());
  }
  if (sampled_at != state.time) recorder.sample(state, stepper.account(), clock.keeps_history());
  recorder.demands().time_of_overturning = clock.overturned_at();

  Response response;
  response.outcome = clock.outcome();
  response.cause = clock.cause();
  response.quality = stepper.quality();
  response.quality.collision_passes = world.collision_passes();
  recorder.finish(state, stepper.account(), response);
  return response;
}

}  // namespace

Response simulate(const Scene& scene, const Excitation& excitation,
                  const SimulationSettings& settings) {
  validate(scene);
  validate(excitation);
  validate(settings);
  const bool stock =
      settings.solver == Solver::kBullet || settings.solver == Solver::kBulletDantzig;
  return stock ? simulate_on_stock_bullet(scene, excitation, settings)
               : simulate_with_star(scene, excitation, settings);
}

}  // namespace gurney
