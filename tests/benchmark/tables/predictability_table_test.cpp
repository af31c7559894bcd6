#include <gtest/gtest.h>

#include "tests/benchmark/regimes.h"

// A part of the table of docs/theory/predictability.md, which `./dev bench --predictability` makes
// with 100 motions a regime. Single runs may differ from one compiler to the next, so counts are
// held to the table's fractions within 3.5 binomial standard deviations, 1 in 4000.
namespace gurney::benchmark {
namespace {

using Verdict = Predictability::Verdict;

constexpr int kMotions = 100;  // of the table
constexpr double kSettled = 0.01, kNearlySettled = 0.05;

struct Counts {
  int runs = 0, predictable = 0, settled = 0, nearly = 0;
};

/// Every twentieth motion from `first` on.
Counts counts_of(const Regime& regime, int first) {
  const Scene scene = scene_of_regime(regime);
  Counts counts;
  for (int k = first; k < kMotions; k += 20) {
    const auto run = judged_run(scene, motion_of_regime(regime, k, kMotions));
    if (!run) continue;
    ++counts.runs;
    counts.predictable += run->verdict == Verdict::kPredictable;
    counts.settled += run->error <= kSettled;
    counts.nearly += run->error <= kNearlySettled;
  }
  return counts;
}

// All 100 are predictable and within 5 %, 93 and 90 within 1 %: 4.65 and 4.5 of 5, less 3.5 times
// 0.57 and 0.67.
TEST(PredictabilityTable, FreeAndWeaklyShakenItemsHaveNumbers) {
  for (const Regime& regime : {kRegimes[0], kRegimes[3]}) {
    SCOPED_TRACE(regime.name);
    const Counts counts = counts_of(regime, 10);
    EXPECT_EQ(counts.runs, 5);
    EXPECT_EQ(counts.predictable, 5);
    EXPECT_EQ(counts.nearly, 5);
    EXPECT_GE(counts.settled, 3);
  }
}

// None of the 91 that are sensitive or chaotic is within 1 % of the finest step, of all 100 one.
TEST(PredictabilityTable, StronglyShakenBrakedItemsDoNotSettle) {
  EXPECT_LE(counts_of(kRegimes[4], 10).settled, 1);
}

// 9, 28 and 63 of 100: of 20 no more than 1.8 + 3.5 * 1.28 are predictable, no fewer than
// 12.6 - 3.5 * 2.16 chaotic.
TEST(PredictabilityTable, MostStronglyShakenBrakedItemsAreChaotic) {
  const Regime& regime = kRegimes[4];
  const Scene scene = scene_of_regime(regime);
  int predictable = 0, chaotic = 0;
  for (int k = 2; k < kMotions; k += 5) {
    const auto verdict = verdict_of_run(scene, motion_of_regime(regime, k, kMotions));
    predictable += verdict == Verdict::kPredictable;
    chaotic += verdict == Verdict::kChaotic;
  }
  EXPECT_LE(predictable, 6);
  EXPECT_GE(chaotic, 6);
}

}  // namespace
}  // namespace gurney::benchmark
