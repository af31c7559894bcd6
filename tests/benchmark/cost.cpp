#include <fmt/core.h>

#include <algorithm>
#include <ctime>

#include "tests/benchmark/crowd.h"
#include "tests/benchmark/free_trolley.h"
#include "tests/benchmark/sections.h"
#include "tests/benchmark/workload.h"

namespace gurney::benchmark {
namespace {

constexpr double kPeak = 0.4;     // [g]
constexpr double kApart = 4;      // items, from each other [m]
constexpr double kDuration = 20;  // [s]
constexpr int kRepeats = 3;

/// Of all threads [s].
double process_time() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double least_cpu(const Scene& scene, const FloorMotion& floor, double duration) {
  double least = 1e300;
  for (int i = 0; i < kRepeats; ++i) {
    const double start = process_time();
    simulate(scene, floor, {.duration = duration, .history_step = 0});
    least = std::min(least, process_time() - start);
  }
  return least;
}

/// The trolley with 4 casters, and others on the lines between its middle and those.
Scene with_casters(std::size_t count) {
  Scene scene = trolley({10, 100, 200, 300});
  std::vector<Caster>& casters = scene.items[0].model.casters;
  for (std::size_t i = 4; i < count; ++i) {
    Caster caster = casters[i - 4];
    caster.name += " inner";
    caster.mount.head<2>() *= 0.5;
    casters.push_back(caster);
  }
  return scene;
}

Scene with_items(std::size_t count) {
  Scene scene = trolley({10, 100, 200, 300});
  for (std::size_t i = 1; i < count; ++i) {
    scene.items.push_back(scene.items[0]);
    scene.items[i].name = fmt::format("trolley {}", i + 1);
    scene.items[i].initial.position.x() = kApart * static_cast<double>(i);
  }
  scene.items[0].name = "trolley 1";
  return scene;
}

void print_crowd(const char* what, int columns, int rows, const FloorMotion& floor) {
  const Scene scene = crowd(columns, rows);
  const double cpu = least_cpu(scene, floor, kDuration);
  const Response run = simulate(scene, floor, {.duration = kDuration, .history_step = 0});
  fmt::print("{:>12} {:>4}: {:>7.2f} ms of CPU, {:.0f} x real time, {} impacts\n", what,
             columns * rows, 1e3 * cpu, kDuration / cpu, run.impacts.size());
}

FloorMotion repeated(const FloorMotion& floor, int times) {
  return FloorMotion(floor.time_step(), floor.acceleration().replicate(1, times));
}

void print_row(const char* what, double count, double cpu, double first_count, double first) {
  fmt::print("{:>12} {:>4g}: {:>7.2f} ms of CPU, {:.2f} of proportional\n", what, count, 1e3 * cpu,
             cpu / first * first_count / count);
}

void print_free_trolley() {
  constexpr int kMotions = 24;
  fmt::print(
      "\nFree trolley, {} motions of {:g} s: x real time; median and 90 % of the error of the "
      "peak\n"
      "displacement against that at 0.25 ms\n",
      kMotions, kDuration);
  for (const FreeTrolleyPoint& point : free_trolley({0.004, 0.01, 0.0125, 0.02}, kMotions))
    fmt::print("| {:g} ms | {:.0f} | {:.2f} % | {:.2f} % |\n", 1e3 * point.step, point.speed,
               100 * point.median_error, 100 * point.larger_error);
}

double batch(const Scene& scene, const FloorMotion& floor, double duration, int runs, int threads) {
  const double start = process_time();
#pragma omp parallel for schedule(dynamic) num_threads(threads)
  for (int i = 0; i < runs; ++i) simulate(scene, floor, {.duration = duration, .history_step = 0});
  return process_time() - start;
}

}  // namespace

void print_cost() {
  fmt::print("\nCPU time of a run of {:g} s, 4 ms steps, least of {}\n", kDuration, kRepeats);
  const FloorMotion floor = shaking(1, kPeak);
  const double four = least_cpu(with_casters(4), floor, kDuration);
  for (const std::size_t count : {4, 6, 8})
    print_row("casters", double(count), least_cpu(with_casters(count), floor, kDuration), 4, four);
  for (const std::size_t count : {1, 2, 4, 8})
    print_row("items", double(count), least_cpu(with_items(count), floor, kDuration), 1, four);
  for (const int times : {1, 2, 4, 8})
    print_row("length x 20 s", times,
              least_cpu(with_casters(4), repeated(floor, times), times * kDuration), 1, four);
  fmt::print("a run of one step: {:.3f} ms of CPU\n",
             1e3 * least_cpu(with_casters(4), floor, 0.004));
  print_free_trolley();
  print_crowd("in walls", 1, 1, floor);
  print_crowd("in walls", 5, 2, floor);
  for (const double duration : {1.0, kDuration}) {
    const int runs = duration > 1 ? 40 : 400;
    const Scene scene = with_casters(4);
    const double one = batch(scene, floor, duration, runs, 1);
    const double two = batch(scene, floor, duration, runs, 2);
    fmt::print("{} runs of {:g} s: CPU time on one thread over that on two {:.3f}\n", runs,
               duration, one / two);
  }
}

}  // namespace gurney::benchmark
