#include "engine/baselines/any_solver.h"

#include "engine/baselines/stock_baseline.h"
#include "engine/run/simulate.h"

namespace gurney::baselines {

Response simulate_with_any_solver(const Scene& scene, const FloorMotion& floor,
                                  const SimulationSettings& settings) {
  return settings.solver == Solver::kImplicit ? simulate(scene, floor, settings)
                                              : simulate_on_stock_bullet(scene, floor, settings);
}

}  // namespace gurney::baselines
