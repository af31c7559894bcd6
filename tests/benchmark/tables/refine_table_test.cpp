#include <gtest/gtest.h>

#include "engine/run/refine.h"
#include "engine/run/twin.h"
#include "tests/benchmark/regimes.h"

// A part of the table of docs/theory/predictability.md, which `./dev bench --refine` makes:
// two of 100 motions a regime. One of the 51 half locked runs is not within 1 %, that of motion 0.
namespace gurney::benchmark {
namespace {

TEST(RefineTable, SettledRunsAreWithinOnePercent) {
  int settled = 0;
  for (const Regime& regime : {kRegimes[0], kRegimes[2], kRegimes[3]}) {
    const Scene scene = scene_of_regime(regime);
    for (const int k : {20, 60}) {
      const FloorMotion floor = motion_of_regime(regime, k, 100);
      constexpr double kPeakError = 0.01;
      const SimulationSettings settings;
      const Response run = refine(scene, floor, settings, kPeakError);
      const SimulationSettings last = refined_settings(settings, run.quality);
      const auto found = predictability(scene, floor, last, run);
      ASSERT_EQ(found.size(), 1u);
      if (found[0].verdict != Predictability::Verdict::kPredictable) continue;
      // The run itself says that it did not settle.
      if (run.quality.peak_change > 0.5 * kPeakError) continue;
      ++settled;
      const Response finest = simulate(scene, floor, {.time_step = 0.004 / 128, .history_step = 0});
      EXPECT_LE(step_error(run.items[0].demands, finest.items[0].demands), 0.01)
          << regime.name << " " << k;
    }
  }
  EXPECT_GE(settled, 4);  // all of the free and weakly shaken ones
}

}  // namespace
}  // namespace gurney::benchmark
