#include "engine/baselines/any_solver.h"

#include "engine/baselines/stock_baseline.h"
#include "engine/run/simulate.h"

namespace gurney::baselines {

Response simulate_with_any_solver(const Scene& scene, const Excitation& excitation,
                                  const SimulationSettings& settings) {
  return settings.solver == Solver::kStar ? simulate(scene, excitation, settings)
                                          : simulate_on_stock_bullet(scene, excitation, settings);
}

}  // namespace gurney::baselines
