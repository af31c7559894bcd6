#include "tests/benchmark/settled.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <thread>
#include <vector>

#include "engine/base/parallel.h"
#include "engine/run/twin.h"
#include "equipment/catalogue/catalogue.h"
#include "equipment/catalogue/load_item.h"
#include "tests/benchmark/sections.h"

namespace gurney::benchmark {
namespace {

constexpr double kFinestStep = 0.004 / 64;  // [s]
constexpr unsigned kFirstSeed = 1000;       // no motion of kRegimes

Scene scene_of_settled(const SettledRegime& regime) {
  equipment::ItemOptions options;
  for (std::size_t i = 0; i < 4; ++i) options.brakes.push_back(i < regime.brakes);
  Scene scene =
      scene_of(equipment::load_item(
                   equipment::find_data(equipment::DataKind::kItem, regime.item, ""), options)
                   .model);
  constexpr double kThickness = 0.2, kLength = 6, kHeight = 2;
  const double inner[] = {regime.wall_x, regime.wall_y};
  for (int axis = 0; axis < 2; ++axis)
    for (const double side : {1.0, -1.0}) {
      if (inner[axis] == 0) continue;
      Vector3 center(0, 0, kHeight / 2), size(kLength, kLength, kHeight);
      center[axis] = side * (inner[axis] + kThickness / 2);
      size[axis] = kThickness;
      scene.room.push_back({"wall " + std::to_string(scene.room.size() + 1), "", center,
                            Quaternion::Identity(), RoomBox{size}});
    }
  return scene;
}

/// By SettledDemand::kFractions.
struct Row {
  std::array<int, std::size(SettledDemand::kFractions)> settled{}, right{};
  int demands = 0;

  void add(const LabelledRun& run) {
    demands += static_cast<int>(run.demands.size());
    for (std::size_t i = 0; i < run.demands.size(); ++i)
      for (std::size_t f = 0; f < settled.size(); ++f)
        if (run.demands[i].within() == SettledDemand::kFractions[f]) {
          ++settled[f];
          right[f] += run.errors[i] <= SettledDemand::kFractions[f];
        }
  }

  void print(const char* name) const {
    int labelled = 0, all_right = 0;
    std::string line = fmt::format("| {} | {} |", name, demands);
    for (std::size_t f = 0; f < settled.size(); ++f) {
      line += fmt::format(" {} of {} |", right[f], settled[f]);
      labelled += settled[f];
      all_right += right[f];
    }
    fmt::print("{} {:.1f} % |\n", line, labelled > 0 ? 100.0 * all_right / labelled : 100);
    std::fflush(stdout);
  }
};

}  // namespace

LabelledRun labelled_run(const SettledRegime& regime, int k, int motions) {
  const Scene scene = scene_of_settled(regime);
  const double share = (k + 0.5) / motions;
  const FloorMotion floor = shaking(kFirstSeed + static_cast<unsigned>(k),
                                    regime.lowest_g + share * (regime.highest_g - regime.lowest_g),
                                    regime.vertical_ratio);
  const SimulationSettings settings;
  Response run = simulate(scene, floor, settings);
  std::vector<Predictability> found = predictability(scene, floor, settings, run);
  if (found.empty()) return {};
  add_half_step(scene, run, half_step_run(scene, floor, settings), found);
  run.items[0].predictability = found[0];
  const Response finest = simulate(scene, floor, {.time_step = kFinestStep, .history_step = 0});
  LabelledRun labelled{found[0].verdict, settled_demands(run.items[0]), {}};
  const std::vector<DemandNumber> reference = numbers_of(finest.items[0].demands);
  for (std::size_t i = 0; i < labelled.demands.size(); ++i)
    labelled.errors.push_back(std::abs(change_between(labelled.demands[i].number, reference[i])));
  return labelled;
}

void print_settled(int motions) {
  fmt::print(
      "\nDemands of {} synthetic motions a regime at 4 ms; of those said to be settled to 1, 2, 5 "
      "and 10 % those\nwithin it of {:g} ms\n",
      motions, 1e3 * kFinestStep);
  Row all;
  for (const SettledRegime& regime : kSettledRegimes) {
    std::vector<LabelledRun> runs(static_cast<std::size_t>(motions));
    const auto threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    parallel_for(runs.size(), threads, [&](std::size_t k) {
      runs[k] = labelled_run(regime, static_cast<int>(k), motions);
    });
    Row row;
    for (const LabelledRun& run : runs) {
      row.add(run);
      all.add(run);
    }
    row.print(regime.name);
  }
  all.print("all");
}

}  // namespace gurney::benchmark
