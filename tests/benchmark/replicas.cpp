#include <fmt/core.h>

#include <cmath>

#include "engine/scene/perturbed.h"
#include "studies/statistics/bands.h"
#include "tests/benchmark/regimes.h"
#include "tests/benchmark/sections.h"

namespace gurney::benchmark {
namespace {

constexpr int kReplicas = 8, kMore = 80;

/// Of replicas `first` and the `count - 1` next ones.
int overturned(const Scene& scene, const FloorMotion& floor, int first, int count) {
  const SimulationSettings settings{.follow_overturning = false, .history_step = 0};
  int sum = 0;
  for (int k = first; k < first + count; ++k)
    sum += simulate(perturbed(scene, static_cast<std::size_t>(k)), floor, settings).outcome ==
           Outcome::kOverturned;
  return sum;
}

}  // namespace

void print_replicas(int motions) {
  const Regime& regime = kRegimes[std::size(kRegimes) - 1];
  const Scene scene = scene_of_regime(regime);
  fmt::print("\n{}: P(overturned) of {} replicas, and of {} others\n", regime.name, kReplicas,
             kMore);
  int cases = 0, covered = 0, between = 0, covered_between = 0;
#pragma omp parallel for schedule(dynamic)
  for (int k = 0; k < motions; ++k) {
    const FloorMotion floor = motion_of_regime(regime, k, motions);
    if (verdict_of_run(scene, floor) != Predictability::Verdict::kChaotic) continue;
    const int few = overturned(scene, floor, 0, kReplicas);
    const int many = overturned(scene, floor, kReplicas, kMore);
    const double truth = static_cast<double>(many) / kMore;
    const bool inside = statistics::proportion_interval(few, kReplicas).contains(truth);
#pragma omp critical
    {
      ++cases;
      covered += inside;
      if (many > 0 && many < kMore) {
        ++between;
        covered_between += inside;
      }
      fmt::print("motion {:>3}: {} of {}, {:>2} of {}{}\n", k + 1, few, kReplicas, many, kMore,
                 inside ? "" : "  outside");
      std::fflush(stdout);
    }
  }
  fmt::print(
      "{} of {} motions are chaotic; the 95 % interval of {} replicas contains the P of {} "
      "others in {} ({} of {} where P is neither 0 nor 1)\n",
      cases, motions, kReplicas, kMore, covered, covered_between, between);
}

}  // namespace gurney::benchmark
