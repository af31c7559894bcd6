#include <gtest/gtest.h>

#include <cmath>

#include "engine/scene/perturbed.h"
#include "studies/statistics/bands.h"
#include "tests/benchmark/coverage.h"
#include "tests/benchmark/regimes.h"

// P from a few replicas: docs/theory/predictability.md.
namespace gurney::benchmark {
namespace {

double binomial(int n, int k, double p) {
  return std::exp(std::lgamma(n + 1.0) - std::lgamma(k + 1.0) - std::lgamma(n - k + 1.0) +
                  k * std::log(p) + (n - k) * std::log1p(-p));
}

// Outcomes of a known P; all counts enumerated. Clopper and Pearson's interval has at least its
// confidence at every P. The P of kMore others adds a scatter of its own, but the slack of eight
// trials is larger: 96 % at least.
TEST(Replicas, IntervalOfEightCoversAKnownProbability) {
  for (int percent = 1; percent < 100; ++percent) {
    SCOPED_TRACE(percent);
    const double p = percent / 100.0;
    double truth = 0, others = 0;
    for (int few = 0; few <= kReplicas; ++few) {
      const double chance = binomial(kReplicas, few, p);
      if (statistics::proportion_interval(few, kReplicas).contains(p)) truth += chance;
      for (int many = 0; many <= kMore; ++many)
        if (covers(few, many)) others += chance * binomial(kMore, many, p);
    }
    EXPECT_GE(truth, 0.95);
    EXPECT_GE(others, 0.96);
  }
}

// The mean of the conditional probability over the totals is the unconditional one, exactly.
TEST(Replicas, ProbabilityOfCoverAveragesToThatOfIndependentSamples) {
  for (const double p : {0.05, 0.3, 0.5}) {
    double given = 0, direct = 0;
    for (int total = 0; total <= kReplicas + kMore; ++total)
      given += binomial(kReplicas + kMore, total, p) * probability_of_cover(total);
    for (int few = 0; few <= kReplicas; ++few)
      for (int many = 0; many <= kMore; ++many)
        if (covers(few, many)) direct += binomial(kReplicas, few, p) * binomial(kMore, many, p);
    EXPECT_NEAR(given, direct, 1e-10);
  }
}

TEST(Replicas, AreHeavierOrLighterByWhatNobodyCanMeasure) {
  const Scene scene = scene_of_regime(kRegimes[4]);
  const auto mass = [&](std::size_t k) {
    return replica_of(scene, k).items[0].model.chassis_mass / scene.items[0].model.chassis_mass - 1;
  };
  EXPECT_EQ(mass(0), 0);
  int heavier = 0;
  for (std::size_t k = 1; k <= 100; ++k) {
    EXPECT_LE(std::abs(mass(k)), kReplicaSpread * (1 + 1e-9));
    EXPECT_NE(mass(k), mass(k + 1));
    heavier += mass(k) > 0;
  }
  EXPECT_NEAR(heavier, 50, 20);  // four standard deviations of 100 tosses
}

// A motion under which some overturn. With masses that grow by 1e-9 from one replica to the next, 45 of
// the first 45 and 14 of the other 45 overturned under one like it. Of independent replicas the
// halves differ by no more than 3.5 standard deviations of the hypergeometric distribution, 1 in
// 2000.
TEST(Replicas, HalvesAreAlike) {
  constexpr int kHalf = 45, kMotion = 158, kMotions = 170;
  const Regime& regime = kRegimes[4];
  const Scene scene = scene_of_regime(regime);
  const FloorMotion floor = motion_of_regime(regime, kMotion, kMotions);
  double of_half[2] = {0, 0};
  for (int k = 0; k < 2 * kHalf; ++k)
    of_half[k / kHalf] += simulate(replica_of(scene, static_cast<std::size_t>(1 + k)), floor,
                                   {.follow_overturning = false, .history_step = 0})
                              .outcome == Outcome::kOverturned;
  const double p = (of_half[0] + of_half[1]) / (2 * kHalf);
  EXPECT_GT(p, 0.2);
  EXPECT_LT(p, 0.8);
  const double variance = 0.5 * kHalf * p * (1 - p) * 2 * kHalf / (2 * kHalf - 1);
  EXPECT_LE(std::abs(of_half[0] - of_half[1]) / 2, 3.5 * std::sqrt(variance));
}

}  // namespace
}  // namespace gurney::benchmark
