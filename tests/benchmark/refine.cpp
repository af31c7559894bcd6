#include "engine/run/refine.h"

#include <fmt/core.h>

#include "engine/run/twin.h"
#include "tests/benchmark/regimes.h"
#include "tests/benchmark/sections.h"

namespace gurney::benchmark {
namespace {

constexpr double kFinestStep = 0.004 / 128;  // [s]
constexpr double kPeakError = 0.01;

struct Row {
  int predictable = 0, unsettled = 0, within = 0;
  double cpu = 0;
};

void add_motion(const Scene& scene, const FloorMotion& floor, Row& row) {
  const SimulationSettings settings;
  const double start = cpu_time();
  const Response run = refine(scene, floor, settings, kPeakError);
  const double cpu = cpu_time() - start;
  const SimulationSettings last = refined_settings(settings, run.quality);
  const std::vector<Predictability> found = predictability(scene, floor, last, run);
  const bool predictable =
      !found.empty() && found[0].verdict == Predictability::Verdict::kPredictable;
  bool within = false;
  if (predictable) {
    const Response finest = simulate(scene, floor, {.time_step = kFinestStep, .history_step = 0});
    within = step_error(run.items[0].demands, finest.items[0].demands) <= kPeakError;
  }
#pragma omp critical
  {
    row.predictable += predictable;
    row.unsettled += predictable && run.quality.peak_change > 0.5 * kPeakError;
    row.within += within;
    row.cpu += cpu;
  }
}

}  // namespace

void print_refine(int motions) {
  fmt::print(
      "\npeak_error = {:g}: of {} synthetic motions a regime the predictable runs, those "
      "of them that\nsix halvings did not settle, those within {:g} % of {:g} ms, and the CPU "
      "time of a run\n",
      kPeakError, motions, 100 * kPeakError, 1e3 * kFinestStep);
  for (const Regime& regime : kRegimes) {
    const Scene scene = scene_of_regime(regime);
    Row row;
#pragma omp parallel for schedule(dynamic)
    for (int k = 0; k < motions; ++k) add_motion(scene, motion_of_regime(regime, k, motions), row);
    fmt::print("| {} | {} | {} | {} | {:.2f} s |\n", regime.name, row.predictable, row.unsettled,
               row.within, row.cpu / motions);
    std::fflush(stdout);
  }
}

}  // namespace gurney::benchmark
