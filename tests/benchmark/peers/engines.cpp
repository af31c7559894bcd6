#include "tests/benchmark/peers/engines.h"

namespace gurney::benchmark {
namespace {

using peers::CrossCheck;
using peers::Path;
using peers::Setup;

Engine peer(const char* name, const char* setup, Path (*path)(const CrossCheck&, double, Setup),
            Setup how, const std::vector<double>& steps) {
  const auto run = [path, how](const CrossCheck& check, double step) {
    return path(check, step, how);
  };
  return {.name = name,
          .setup = setup,
          .steps = steps,
          .euler = true,
          .shared_model = how == Setup::kBest,
          .run = run,
          .fixed_step = run};
}

}  // namespace

std::vector<Engine> engines(const std::vector<double>& steps,
                            const std::vector<double>& tolerances) {
  std::vector<Engine> all = own_engines(steps, tolerances);
  all.insert(all.end(),
             {peer("MuJoCo", "defaults", peers::mujoco_path, Setup::kDefaults, steps),
              peer("MuJoCo", "stiff", peers::mujoco_path, Setup::kStiff, steps),
              peer("MuJoCo", "stiff, elliptic, 1e-14", peers::mujoco_path, Setup::kBest, steps),
              peer("ODE", "QuickStep", peers::ode_path, Setup::kDefaults, steps),
              peer("ODE", "Dantzig", peers::ode_path, Setup::kStiff, steps),
              peer("ODE", "Dantzig, friction by loads", peers::ode_path, Setup::kBest, steps)});
  return all;
}

}  // namespace gurney::benchmark
