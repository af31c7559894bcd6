#include "engine/run/run.h"
#include "tests/benchmark/peers/engines.h"
#include "tests/benchmark/peers/jobs.h"

namespace gurney::benchmark {
namespace {

using peers::CrossCheck;
using peers::Path;

Path gurney_path(const Scene& scene, const CrossCheck& check, RunOptions settings) {
  settings.duration = check.duration;
  settings.history_step = check.sampling;
  settings.follow_overturning = false;
  settings.overturn_tilt = peers::kOverturned;
  const Response response = gurney::run(scene, check.floor, settings);
  Path path;
  for (const Sample& sample : response.items[0].history)
    path.push_back({{sample.displacement.x(), sample.displacement.y(), sample.yaw}, sample.tilt});
  return path;
}

Engine ours(const char* setup, bool rigid, const std::vector<double>& steps) {
  const auto run = [rigid](const CrossCheck& check, double step) {
    return gurney_path(rigid ? with_rigid_treads(check.scene) : check.scene, check,
                       {{.time_step = step}});
  };
  return {.name = "Gurney",
          .setup = setup,
          .steps = steps,
          .shared_model = rigid,
          .run = run,
          .fixed_step = run};
}

Engine with_tolerance(const std::vector<double>& tolerances) {
  Engine engine = ours("real treads, tolerance", false, tolerances);
  engine.chooses_steps = true;
  engine.run = [](const CrossCheck& check, double tolerance) {
    return gurney_path(check.scene, check, {{.tolerance = tolerance}});
  };
  return engine;
}

Engine bullet(const char* setup, Solver solver, const std::vector<double>& steps) {
  const auto run = [solver](const CrossCheck& check, double step) {
    return gurney_path(check.scene, check, {{.time_step = step}, solver});
  };
  return {.name = "Bullet",
          .setup = setup,
          .steps = steps,
          .euler = true,
          .run = run,
          .fixed_step = run};
}

}  // namespace

std::vector<Engine> own_engines(const std::vector<double>& steps,
                                const std::vector<double>& tolerances) {
  return {ours("real treads, fixed steps", false, steps), with_tolerance(tolerances),
          ours("rigid treads, fixed steps", true, steps),
          bullet("sequential impulse", Solver::kBullet, steps),
          bullet("Dantzig", Solver::kBulletDantzig, steps)};
}

}  // namespace gurney::benchmark
