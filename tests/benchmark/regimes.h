#pragma once

#include <optional>
#include <vector>

#include "engine/response/predictability.h"
#include "tests/benchmark/workload.h"

namespace gurney::benchmark {

/// The shipped ICU ventilator under motions of a range of peaks, the first casters of it braked;
/// between walls: 0.25 m from each of its sides.
struct Regime {
  const char* name;
  std::size_t brakes;
  double lowest_g, highest_g;
  bool between_walls;
};

inline constexpr Regime kRegimes[] = {{"free", 0, 0.2, 0.8, false},
                                      {"free, with impacts", 0, 0.2, 0.8, true},
                                      {"half locked", 2, 0.2, 0.8, false},
                                      {"braked, weak motion", 4, 0.05, 0.2, false},
                                      {"braked, strong motion", 4, 0.4, 0.8, false}};

Scene scene_of_regime(const Regime& regime);

/// The k-th of `records` synthetic motions with peaks spread over the range.
FloorMotion motion_of_regime(const Regime& regime, int k, int records);

/// How far a run's peaks of displacement and tilt are from those of the finest step, over the
/// latter; of items that overturn, the time; infinite where only one overturns.
double step_error(const Demands& run, const Demands& finest);

/// A run at the default step of 4 ms, its verdict, and its error against 0.25 ms.
struct JudgedRun {
  Predictability::Verdict verdict;
  double error;
};
std::optional<Predictability::Verdict> verdict_of_run(const Scene& scene, const FloorMotion& floor);
std::optional<JudgedRun> judged_run(const Scene& scene, const FloorMotion& floor);
/// Of each item; none where the twin fails.
std::vector<JudgedRun> judged_items(const Scene& scene, const FloorMotion& floor);

}  // namespace gurney::benchmark
