#include "studies/calibration/fit/rolling.h"

#include <gmock/gmock.h>

#include <cmath>
#include <map>

#include "engine/base/random/normal_draw.h"
#include "studies/calibration/trials/trial_check.h"
#include "studies/statistics/special.h"
#include "tests/studies/calibration/fit/coverage.h"

namespace gurney::calibration {
namespace {

constexpr double kTruth = 0.02;    // Cr / R
constexpr double kScatter = 0.01;  // of ln Cr between trials
constexpr int kPool = 50;          // trials of each load
constexpr int kPulls = 12;         // in one calibration

TrialAverages averages(const Trial& trial) {
  check_samples(trial);
  const Phases phases = find_phases(trial);
  const TrialAverages found = averages_of(trial, phases);
  check_averages(found, true);
  check_phases(trial, phases);
  return found;
}

/// Trials whose Cr are the quantiles of the scatter at (i + 1/2) / 50: drawing among them is
/// drawing Cr, with 1.5 % less variance than the scatter's.
const std::vector<Trial>& pool(int pavers) {
  static std::map<int, std::vector<Trial>> made;
  std::vector<Trial>& trials = made[pavers];
  for (int i = static_cast<int>(trials.size()); i < kPool; ++i) {
    VirtualPull pull;
    pull.pavers = pavers;
    pull.drop_mass = (i % 2 == 0 ? 5 : 6.5) + 0.6 * pavers;
    pull.resistance = kTruth * std::exp(kScatter * normal_quantile((i + 0.5) / kPool));
    trials.push_back(virtual_pull(pull));
  }
  return trials;
}

/// What a laboratory measures in repeat `repeat`: 6 pulls without and 6 with four pavers.
std::vector<TrialAverages> laboratory(int repeat) {
  std::vector<TrialAverages> measured;
  for (int i = 0; i < kPulls; ++i) {
    const auto seed = static_cast<std::uint64_t>(repeat), stream = static_cast<std::uint64_t>(i);
    const auto drawn = static_cast<std::size_t>(kPool * uniform_draw(seed, 100 + stream, 0));
    const Trial trial = with_noise(pool(i < kPulls / 2 ? 0 : 4)[drawn], seed, stream);
    measured.push_back(averages(trial));
  }
  return measured;
}

// Noise-free trials: what is left is the engine's pitching, wind-up and cable against the rigid
// equilibrium. Half of the narrowest interval below is 0.6 %; a bias of 0.05 % hides in it.
TEST(RollingCalibration, HasNoBiasWithoutNoise) {
  for (const double resistance : {0.01, 0.02, 0.03}) {
    VirtualPull pull;
    pull.resistance = resistance;
    pull.drop_mass = 3 + 200 * resistance;
    const TrialAverages found = averages(virtual_pull(pull));
    const Resistance r = average_method(found);
    const double truth = resistance * normal_force(found.setup);
    EXPECT_NEAR(r.coasting / truth, 1, 5e-4);
    EXPECT_NEAR(r.pulled / truth, 1, 2e-3);
  }
}

TEST(RollingCalibration, IntervalsHoldTheTruthAsOftenAsStated) {
  int covered = 0, covered_load = 0, predicted = 0;
  std::map<std::string, int> rejected;
  int outliers = 0;
  for (int repeat = 0; repeat < kRepeats; ++repeat) {
    std::vector<RollingTrial> trials;
    std::vector<TrialValue> values;
    for (const TrialAverages& each : laboratory(repeat)) {
      trials.push_back({each, average_method(each)});
      values.push_back(value_of(trials.back()));
    }
    const std::vector<Constant> constants = constants_of(values);
    ASSERT_EQ(constants.size(), 1u);
    const Constant& ratio = constants[0];
    covered += ratio.interval.contains(kTruth);
    EXPECT_NEAR(ratio.scatter, kScatter, 4 * kScatter / std::sqrt(2.0 * kPulls));
    predicted += ratio.prediction.contains(
        kTruth * std::exp(kScatter * normal_draw(static_cast<std::uint64_t>(repeat), 999, 0)));
    for (const RollingTest& test : rolling_tests(trials)) {
      rejected[test.name] += test.p < 0.05;
      if (test.name == "load") covered_load += test.interval.contains(1);
    }
    outliers += !outliers_of(values).empty();
  }
  const statistics::Interval often = acceptance(0.95), seldom = acceptance(0.05);
  EXPECT_TRUE(often.contains(covered)) << covered;
  EXPECT_TRUE(often.contains(predicted)) << predicted;
  EXPECT_TRUE(often.contains(covered_load)) << covered_load;
  EXPECT_TRUE(seldom.contains(rejected["load"])) << rejected["load"];
  EXPECT_TRUE(seldom.contains(rejected["speed between trials"]))
      << rejected["speed between trials"];
  EXPECT_LE(outliers, seldom.high);
}

}  // namespace
}  // namespace gurney::calibration
