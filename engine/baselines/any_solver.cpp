#include "engine/baselines/any_solver.h"

#include "engine/baselines/stock_baseline.h"
#include "engine/run/predictability.h"
#include "engine/run/simulate.h"

namespace gurney::baselines {

Response simulate_with_any_solver(const Scene& scene, const FloorMotion& floor,
                                  const SimulationSettings& settings) {
  return settings.solver == Solver::kImplicit ? simulate(scene, floor, settings)
                                              : simulate_on_stock_bullet(scene, floor, settings);
}

void add_predictability(const Scene& scene, const FloorMotion& floor,
                        const SimulationSettings& settings, Response& response) {
  if (settings.solver != Solver::kImplicit || is_failure(response.outcome)) return;
  std::vector<Predictability> found = predictability(scene, floor, settings, response);
  add_half_step(scene, floor, settings, found);
  for (std::size_t i = 0; i < found.size(); ++i) response.items[i].predictability = found[i];
}

}  // namespace gurney::baselines
