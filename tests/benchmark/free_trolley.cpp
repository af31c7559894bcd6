#include "tests/benchmark/free_trolley.h"

#include <algorithm>
#include <cmath>

#include "tests/benchmark/workload.h"

namespace gurney::benchmark {
namespace {

constexpr double kFinestStep = 0.00025, kDuration = 20;  // [s]
constexpr double kPeak = 0.4;                            // [g]
constexpr int kRepeats = 3;

}  // namespace

std::vector<FreeTrolleyPoint> free_trolley(const std::vector<double>& steps, int motions) {
  const Scene scene = trolley({10, 100, 200, 300});
  std::vector<FloorMotion> floors;
  const auto peak = [&](std::size_t motion, double step) {
    const SimulationSettings settings{.time_step = step, .duration = kDuration, .history_step = 0};
    return simulate(scene, floors[motion], settings).items[0].demands.peak_displacement;
  };
  std::vector<double> finest;
  for (int i = 0; i < motions; ++i) {
    floors.push_back(shaking(static_cast<unsigned>(i + 1), kPeak));
    finest.push_back(peak(finest.size(), kFinestStep));
  }
  std::vector<FreeTrolleyPoint> points;
  for (const double step : steps) {
    double cpu = 0;
    std::vector<double> errors;
    for (std::size_t i = 0; i < floors.size(); ++i) {
      double found = 0, least = 1e300;
      for (int k = 0; k < kRepeats; ++k) {
        const double start = cpu_time();
        found = peak(i, step);
        least = std::min(least, cpu_time() - start);
      }
      cpu += least;
      errors.push_back(std::abs(found / finest[i] - 1));
    }
    std::ranges::sort(errors);
    points.push_back({step, kDuration * static_cast<double>(errors.size()) / cpu,
                      errors[errors.size() / 2], errors[errors.size() * 9 / 10]});
  }
  return points;
}

}  // namespace gurney::benchmark
