#include "tests/benchmark/regimes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/run/twin.h"
#include "equipment/catalogue/catalogue.h"
#include "equipment/catalogue/load_item.h"

namespace gurney::benchmark {
namespace {

constexpr double kDefaultStep = 0.004, kFinestStep = 0.00025;  // [s]

/// Inner faces of walls of 0.2 m, 0.25 m from the base of 647 x 547 mm.
void add_walls(Scene& scene) {
  const Vector2 inner(0.324 + 0.25, 0.274 + 0.25);
  constexpr double kThickness = 0.2, kLength = 4, kHeight = 2;
  for (int axis = 0; axis < 2; ++axis)
    for (const double side : {1.0, -1.0}) {
      Vector3 center(0, 0, kHeight / 2), size(kLength, kLength, kHeight);
      center[axis] = side * (inner[axis] + kThickness / 2);
      size[axis] = kThickness;
      scene.room.push_back({"wall " + std::to_string(scene.room.size() + 1), "", center,
                            Quaternion::Identity(), RoomBox{size}});
    }
}

}  // namespace

Scene scene_of_regime(const Regime& regime) {
  equipment::ItemOptions options;
  for (std::size_t i = 0; i < 4; ++i) options.brakes.push_back(i < regime.brakes);
  Scene scene =
      scene_of(equipment::load_item(
                   equipment::find_data(equipment::DataKind::kItem, "icu_ventilator", ""), options)
                   .model);
  if (regime.between_walls) add_walls(scene);
  return scene;
}

FloorMotion motion_of_regime(const Regime& regime, int k, int records) {
  const double share = (k + 0.5) / records;
  return shaking(static_cast<unsigned>(k + 1),
                 regime.lowest_g + share * (regime.highest_g - regime.lowest_g));
}

double step_error(const Demands& run, const Demands& finest) {
  const bool here = run.time_of_overturning >= 0, there = finest.time_of_overturning >= 0;
  if (here != there) return std::numeric_limits<double>::infinity();
  if (here) return std::abs(run.time_of_overturning / finest.time_of_overturning - 1);
  return std::max(std::abs(run.peak_displacement / finest.peak_displacement - 1),
                  std::abs(run.peak_tilt / finest.peak_tilt - 1));
}

std::optional<Predictability::Verdict> verdict_of_run(const Scene& scene,
                                                      const FloorMotion& floor) {
  const SimulationSettings settings{.time_step = kDefaultStep};
  const auto found = predictability(scene, floor, settings, simulate(scene, floor, settings));
  if (found.empty()) return {};
  return found[0].verdict;
}

std::vector<JudgedRun> judged_items(const Scene& scene, const FloorMotion& floor) {
  const SimulationSettings settings{.time_step = kDefaultStep};
  const Response run = simulate(scene, floor, settings);
  const auto found = predictability(scene, floor, settings, run);
  if (found.empty()) return {};
  const Response finest = simulate(scene, floor, {.time_step = kFinestStep});
  std::vector<JudgedRun> judged;
  for (std::size_t i = 0; i < found.size(); ++i)
    judged.push_back({found[i].verdict, step_error(run.items[i].demands, finest.items[i].demands)});
  return judged;
}

std::optional<JudgedRun> judged_run(const Scene& scene, const FloorMotion& floor) {
  const std::vector<JudgedRun> judged = judged_items(scene, floor);
  if (judged.empty()) return {};
  return judged[0];
}

}  // namespace gurney::benchmark
