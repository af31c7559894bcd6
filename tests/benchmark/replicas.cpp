#include <fmt/core.h>

#include <cmath>

#include "engine/scene/perturbed.h"
#include "tests/benchmark/coverage.h"
#include "tests/benchmark/regimes.h"
#include "tests/benchmark/sections.h"

namespace gurney::benchmark {
namespace {

/// Of replicas `first` and the `count - 1` next ones.
int overturned(const Scene& scene, const FloorMotion& floor, int first, int count) {
  const SimulationSettings settings{.follow_overturning = false, .history_step = 0};
  int sum = 0;
  for (int k = first; k < first + count; ++k)
    sum += simulate(replica_of(scene, static_cast<std::size_t>(k)), floor, settings).outcome ==
           Outcome::kOverturned;
  return sum;
}

struct Counts {
  int cases = 0, covered = 0;
  double expected = 0, variance = 0;

  void add(int few, int many) {
    const double chance = probability_of_cover(few + many);
    ++cases;
    covered += covers(few, many);
    expected += chance;
    variance += chance * (1 - chance);
  }
  void print(const char* what) const {
    fmt::print("{} {}: {} intervals contain the P of the others; {:.1f} +- {:.1f} expected\n",
               cases, what, covered, expected, std::sqrt(variance));
  }
};

}  // namespace

// Replica 0 is the run whose verdict chose the case; it counts in neither sample.
void print_replicas(int motions) {
  const Regime& regime = kRegimes[std::size(kRegimes) - 1];
  const Scene scene = scene_of_regime(regime);
  fmt::print("\n{}: P(overturned) of {} replicas, and of {} others\n", regime.name, kReplicas,
             kMore);
  Counts all, between;
#pragma omp parallel for schedule(dynamic)
  for (int k = 0; k < motions; ++k) {
    const FloorMotion floor = motion_of_regime(regime, k, motions);
    if (verdict_of_run(scene, floor) != Predictability::Verdict::kChaotic) continue;
    const int few = overturned(scene, floor, 1, kReplicas);
    const int many = overturned(scene, floor, 1 + kReplicas, kMore);
#pragma omp critical
    {
      all.add(few, many);
      if (many > 0 && many < kMore) between.add(few, many);
      fmt::print("motion {:>3}: {} of {}, {:>2} of {}{}\n", k + 1, few, kReplicas, many, kMore,
                 covers(few, many) ? "" : "  outside");
      std::fflush(stdout);
    }
  }
  all.print("chaotic cases");
  between.print("of them where P is neither 0 nor 1");
}

}  // namespace gurney::benchmark
