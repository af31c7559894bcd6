#include "engine/run/run.h"

#include "engine/baselines/stock_baseline.h"
#include "engine/run/refine.h"
#include "engine/run/simulate.h"
#include "engine/run/twin.h"

namespace gurney {

Response run(const Scene& scene, const FloorMotion& floor, const SimulationSettings& settings) {
  if (settings.solver != Solver::kImplicit)
    return baselines::simulate_on_stock_bullet(scene, floor, settings);
  return settings.peak_error > 0 ? refine(scene, floor, settings)
                                 : simulate(scene, floor, settings);
}

void add_predictability(const Scene& scene, const FloorMotion& floor,
                        const SimulationSettings& stated, Response& response) {
  if (stated.solver != Solver::kImplicit || is_failure(response.outcome)) return;
  const SimulationSettings settings = refined_settings(stated, response.quality);
  std::vector<Predictability> found = predictability(scene, floor, settings, response);
  add_half_step(scene, floor, settings, found);
  for (std::size_t i = 0; i < found.size(); ++i) response.items[i].predictability = found[i];
}

}  // namespace gurney
