#include "engine/run/predictability.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "equipment/catalogue/catalogue.h"
#include "equipment/catalogue/load_item.h"
#include "tests/benchmark/sections.h"
#include "tests/benchmark/workload.h"

namespace gurney::benchmark {
namespace {

constexpr double kStep = 0.004, kFinestStep = 0.00025;  // [s]
constexpr double kSettled = 0.01, kNearlySettled = 0.05;

/// The ventilator under motions of a range of peaks, the first casters of it braked.
struct Regime {
  const char* name;
  std::size_t brakes;
  double lowest_g, highest_g;
};

constexpr Regime kRegimes[] = {{"free", 0, 0.2, 0.8},
                               {"half locked", 2, 0.2, 0.8},
                               {"braked, weak motion", 4, 0.05, 0.2},
                               {"braked, strong motion", 4, 0.4, 0.8}};

Scene ventilator(std::size_t brakes) {
  equipment::ItemOptions options;
  for (std::size_t i = 0; i < 4; ++i) options.brakes.push_back(i < brakes);
  return scene_of(
      equipment::load_item(equipment::find_data(equipment::DataKind::kItem, "icu_ventilator", ""),
                           options)
          .model);
}

/// How far the coarse run's peaks are from those of the finest step, over the latter; infinite where
/// only one overturns.
double step_error(const Demands& coarse, const Demands& finest) {
  const bool here = coarse.time_of_overturning >= 0, there = finest.time_of_overturning >= 0;
  if (here != there) return std::numeric_limits<double>::infinity();
  const double moved =
      std::abs(coarse.peak_displacement - finest.peak_displacement) / finest.peak_displacement;
  const double tilted = std::abs(coarse.peak_tilt - finest.peak_tilt) / finest.peak_tilt;
  return here ? std::abs(coarse.time_of_overturning / finest.time_of_overturning - 1)
              : std::max(moved, tilted);
}

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
    const Scene scene = ventilator(regime.brakes);
    std::array<Row, 3> rows;
#pragma omp parallel for schedule(dynamic)
    for (int k = 0; k < records; ++k) {
      const double share = (k + 0.5) / records;
      const double peak = regime.lowest_g + share * (regime.highest_g - regime.lowest_g);
      const FloorMotion floor = shaking(static_cast<unsigned>(k + 1), peak);
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
