#include "engine/run/predictability.h"

#include <fmt/core.h>

#include <array>

#include "tests/benchmark/regimes.h"
#include "tests/benchmark/sections.h"

namespace gurney::benchmark {
namespace {

constexpr double kStep = 0.004, kFinestStep = 0.00025;  // [s]
constexpr double kSettled = 0.01, kNearlySettled = 0.05;

struct Row {
  int runs = 0, settled = 0, nearly = 0;
  void add(double error) {
    ++runs;
    settled += error <= kSettled;
    nearly += error <= kNearlySettled;
  }
};

}  // namespace

void print_predictability(int records) {
  fmt::print(
      "\nPredictability of the ventilator: {} synthetic motions a regime; runs whose peaks of "
      "displacement\nand tilt at {:g} ms are within {:.0f} % ({:.0f} %) of those at {:g} ms\n",
      records, 1000 * kStep, 100 * kSettled, 100 * kNearlySettled, 1000 * kFinestStep);
  for (const Regime& regime : kRegimes) {
    const Scene scene = scene_of_regime(regime);
    std::array<Row, 3> rows;
#pragma omp parallel for schedule(dynamic)
    for (int k = 0; k < records; ++k) {
      const FloorMotion floor = motion_of_regime(regime, k, records);
      SimulationSettings settings{.time_step = kStep};
      const Response run = simulate(scene, floor, settings);
      const std::vector<Predictability> found = predictability(scene, floor, settings, run);
      settings.time_step = kFinestStep;
      const double error =
          step_error(run.items[0].demands, simulate(scene, floor, settings).items[0].demands);
#pragma omp critical
      if (!found.empty()) rows[static_cast<std::size_t>(found[0].verdict)].add(error);
    }
    for (std::size_t v = 0; v < rows.size(); ++v)
      fmt::print("{:>22} {:>12}: {:>3} runs, {:>3} settled ({:>3} within {:.0f} %)\n",
                 v == 0 ? regime.name : "", name_of(static_cast<Predictability::Verdict>(v)),
                 rows[v].runs, rows[v].settled, rows[v].nearly, 100 * kNearlySettled);
  }
}

}  // namespace gurney::benchmark
