#include "engine/run/run.h"

#include <chrono>
#include <vector>

#include "engine/base/parallel.h"
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

JudgedRun run_judged(const Scene& scene, const FloorMotion& floor, const RunOptions& options,
                     int threads) {
  JudgedRun judged;
  Response& response = judged.response;
  const auto run_it = [&] {
    const auto start = std::chrono::steady_clock::now();
    response = run(scene, floor, options);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    judged.seconds = took.count();
  };
  // A run that chooses its step gives it to the others, one without history is repeated with one.
  const bool at_once =
      options.solver == Solver::kImplicit && options.peak_error == 0 && options.history_step > 0;
  if (!at_once) {
    run_it();
    if (options.solver != Solver::kImplicit || is_failure(response.outcome)) return judged;
  }
  const SimulationSettings settings = refined_settings(options, response.quality);
  Response twin, half;
  std::vector<Predictability> found;
  parallel_for(at_once ? 3 : 2, threads, [&](std::size_t k) {  // the longest first
    if (k == 0)
      half = half_step_run(scene, floor, settings);
    else if (k == 2)
      run_it();
    else if (at_once)
      twin = twin_run(scene, floor, settings);
    else
      found = predictability(scene, floor, settings, response);
  });
  if (is_failure(response.outcome)) return judged;
  if (at_once && !is_failure(twin.outcome)) found = compare_twin(response, twin);
  add_half_step(scene, response, half, found);
  for (std::size_t i = 0; i < found.size(); ++i) response.items[i].predictability = found[i];
  return judged;
}

}  // namespace gurney
