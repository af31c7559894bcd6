#include <fmt/core.h>

#include <array>
#include <vector>

#include "engine/run/twin.h"
#include "tests/benchmark/regimes.h"
#include "tests/benchmark/sections.h"
#include "tests/benchmark/workload.h"

namespace gurney::benchmark {
namespace {

constexpr double kFinestStep = 0.000125, kTwinStep = 0.00025;  // [s]
constexpr double kSettled = 0.01;

constexpr std::array<SimulationSettings, 8> kVariants = {{{.time_step = 0.004},
                                                          {.time_step = 0.002},
                                                          {.time_step = 0.001},
                                                          {.time_step = 0.0005},
                                                          {.time_step = 0.00025},
                                                          {.tolerance = 0.01},
                                                          {.tolerance = 0.003},
                                                          {.tolerance = 0.001}}};

struct Row {
  int settled = 0;
  double cpu = 0;
};

/// What the change with half the step says of the error of the default step.
struct Estimate {
  int covered = 0;  ///< errors within twice the change
  int small = 0;    ///< changes of at most half of kSettled
  int kept = 0;     ///< of these: errors within kSettled
};

struct Table {
  int predictable = 0;
  Estimate estimate;
  std::array<Row, kVariants.size()> rows;
};

void add_motion(const Scene& scene, const FloorMotion& floor, Table& table) {
  const SimulationSettings twin{.time_step = kTwinStep};
  const std::vector<Predictability> found =
      predictability(scene, floor, twin, simulate(scene, floor, twin));
  const Response reference = simulate(scene, floor, {.time_step = kFinestStep});
  const bool predictable =
      !found.empty() && found[0].verdict == Predictability::Verdict::kPredictable;
  std::array<Row, kVariants.size()> rows;
  std::array<Demands, kVariants.size()> demands;
  for (std::size_t v = 0; v < rows.size(); ++v) {
    const double start = cpu_time();
    const Response run = simulate(scene, floor, kVariants[v]);
    rows[v].cpu = cpu_time() - start;
    demands[v] = run.items[0].demands;
    rows[v].settled = predictable && step_error(demands[v], reference.items[0].demands) <= kSettled;
  }
  const double error = step_error(demands[0], reference.items[0].demands),
               change = step_error(demands[0], demands[1]);
#pragma omp critical
  {
    table.predictable += predictable;
    table.estimate.covered += predictable && error <= 2 * change;
    table.estimate.small += predictable && change <= kSettled / 2;
    table.estimate.kept += predictable && change <= kSettled / 2 && error <= kSettled;
    for (std::size_t v = 0; v < rows.size(); ++v) {
      table.rows[v].settled += rows[v].settled;
      table.rows[v].cpu += rows[v].cpu;
    }
  }
}

}  // namespace

void print_step_control(int records) {
  fmt::print(
      "\nFixed steps and steps chosen by a tolerance: {} synthetic motions a regime; predictable "
      "runs (twin at\n{:g} ms) whose peaks are within {:.0f} % of those at {:g} ms, and CPU time "
      "of a run\n",
      records, 1000 * kTwinStep, 100 * kSettled, 1000 * kFinestStep);
  for (const Regime& regime : kRegimes) {
    const Scene scene = scene_of_regime(regime);
    Table table;
#pragma omp parallel for schedule(dynamic)
    for (int k = 0; k < records; ++k)
      add_motion(scene, motion_of_regime(regime, k, records), table);
    fmt::print("{}: {} predictable of {}\n", regime.name, table.predictable, records);
    fmt::print(
        "  errors at 4 ms within twice the change with 2 ms: {}; of {} changes within {:g} %, {} "
        "errors within {:g} %\n",
        table.estimate.covered, table.estimate.small, 50 * kSettled, table.estimate.kept,
        100 * kSettled);
    for (std::size_t v = 0; v < kVariants.size(); ++v) {
      const SimulationSettings& settings = kVariants[v];
      const std::string name = settings.tolerance > 0
                                   ? fmt::format("tolerance {:g}", settings.tolerance)
                                   : fmt::format("{:g} ms", 1000 * settings.time_step);
      fmt::print("{:>18}: {:>3} within {:.0f} %, {:6.1f} ms\n", name, table.rows[v].settled,
                 100 * kSettled, 1000 * table.rows[v].cpu / records);
    }
  }
}

}  // namespace gurney::benchmark
