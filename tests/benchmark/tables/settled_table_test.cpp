#include <gtest/gtest.h>

#include <cmath>
#include <string_view>

#include "tests/benchmark/settled.h"

// A part of the table of docs/theory/predictability.md, which `./dev bench --settled` makes.
namespace gurney::benchmark {
namespace {

using Verdict = Predictability::Verdict;

double change_of(const LabelledRun& run, std::string_view name) {
  for (const SettledDemand& each : run.demands)
    if (each.number.name == name) return each.step_change;
  ADD_FAILURE() << "no " << name;
  return 0;
}

/// What a run was judged by before: its verdict and the change of its two peaks.
bool looks_settled(const LabelledRun& run) {
  return run.verdict == Verdict::kPredictable &&
         std::abs(change_of(run, "peak_displacement")) <= 0.005 &&
         std::abs(change_of(run, "peak_tilt")) <= 0.005;
}

/// Runs whose peaks are settled while others of their numbers are not: between walls the yaw and
/// the residuals, half locked and under a vertical above 1 g forces of wheels.
constexpr struct {
  std::size_t regime;
  int motion;
} kRuns[] = {{1, 3}, {2, 3}, {3, 0}, {4, 0}};

TEST(SettledTable, HoldsOfNineteenOfTwentyDemands) {
  int settled = 0, right = 0, wrong_beside_settled_peaks = 0, of_these_called_settled = 0;
  for (const auto& [regime, motion] : kRuns) {
    const LabelledRun run = labelled_run(kSettledRegimes[regime], motion, 10);
    ASSERT_FALSE(run.demands.empty()) << kSettledRegimes[regime].name;
    for (std::size_t i = 0; i < run.demands.size(); ++i) {
      const SettledDemand& demand = run.demands[i];
      settled += demand.settled();
      right += demand.settled() && run.errors[i] <= demand.within();
      if (!looks_settled(run) || run.errors[i] < 0.2) continue;
      ++wrong_beside_settled_peaks;
      of_these_called_settled += demand.settled();
    }
  }
  EXPECT_GT(settled, 100) << "or the labels refuse everything";
  EXPECT_GE(right, 0.95 * settled);
  EXPECT_GT(wrong_beside_settled_peaks, 0) << "or these runs show nothing";
  EXPECT_EQ(of_these_called_settled, 0);
}

}  // namespace
}  // namespace gurney::benchmark
