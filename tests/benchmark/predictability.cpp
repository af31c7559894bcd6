#include <fmt/core.h>

#include <array>

#include "tests/benchmark/regimes.h"
#include "tests/benchmark/sections.h"

namespace gurney::benchmark {
namespace {

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
      "displacement\nand tilt at 4 ms are within {:.0f} % ({:.0f} %) of those at 0.25 ms\n",
      records, 100 * kSettled, 100 * kNearlySettled);
  for (const Regime& regime : kRegimes) {
    const Scene scene = scene_of_regime(regime);
    std::array<Row, 3> rows;
#pragma omp parallel for schedule(dynamic)
    for (int k = 0; k < records; ++k) {
      const auto run = judged_run(scene, motion_of_regime(regime, k, records));
#pragma omp critical
      if (run) rows[static_cast<std::size_t>(run->verdict)].add(run->error);
    }
    for (std::size_t v = 0; v < rows.size(); ++v)
      fmt::print("{:>22} {:>12}: {:>3} runs, {:>3} settled ({:>3} within {:.0f} %)\n",
                 v == 0 ? regime.name : "", name_of(static_cast<Predictability::Verdict>(v)),
                 rows[v].runs, rows[v].settled, rows[v].nearly, 100 * kNearlySettled);
  }
}

}  // namespace gurney::benchmark
