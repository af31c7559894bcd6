#include "tests/benchmark/peers/pace.h"

#include <algorithm>

#include "tests/benchmark/workload.h"

namespace gurney::benchmark {

double pace() {
  static const Scene scene = trolley({10, 100, 200, 300});
  static const FloorMotion floor = shaking(1, 0.4);
  double least = 1e300;
  for (int i = 0; i < 5; ++i) {
    const double start = cpu_time();
    simulate(scene, floor, {.time_step = 0.01, .duration = 12, .history_step = 0});
    least = std::min(least, cpu_time() - start);
  }
  return least;
}

}  // namespace gurney::benchmark
