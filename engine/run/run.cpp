#include "engine/run/run.h"

#include "engine/baselines/stock_baseline.h"
#include "engine/run/refine.h"
#include "engine/run/simulate.h"
#include "engine/run/twin.h"

namespace gurney {

Response run(const Scene& scene, const FloorMotion& floor, const RunOptions& options) {
  switch (options.solver) {
    case Solver::kImplicit:
      return options.peak_error == 0 ? simulate(scene, floor, options)
                                     : refine(scene, floor, options, options.peak_error);
    case Solver::kBullet:
      return baselines::simulate_on_stock_bullet(scene, floor, options, {});
    case Solver::kBulletDantzig:
      return baselines::simulate_on_stock_bullet(scene, floor, options, {.direct = true});
    case Solver::kBulletPaper:
      return baselines::simulate_on_stock_bullet(scene, floor, options, {.paper = true});
    case Solver::kBulletPaperDantzig:
      break;
  }
  return baselines::simulate_on_stock_bullet(scene, floor, options,
                                             {.paper = true, .direct = true});
}

void add_predictability(const Scene& scene, const FloorMotion& floor, const RunOptions& options,
                        Response& response) {
  if (options.solver != Solver::kImplicit || is_failure(response.outcome)) return;
  const SimulationSettings settings = refined_settings(options, response.quality);
  std::vector<Predictability> found = predictability(scene, floor, settings, response);
  add_half_step(scene, floor, settings, found);
  for (std::size_t i = 0; i < found.size(); ++i) response.items[i].predictability = found[i];
}

}  // namespace gurney
