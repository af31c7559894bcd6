#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/run/run.h"
#include "tests/benchmark/sections.h"
#include "tests/benchmark/workload.h"

namespace gurney::benchmark {
namespace {

constexpr double kDuration = 12;          // [s]
constexpr double kSampling = 0.02;        // [s]; every step below is a whole fraction of it
constexpr double kPathTolerance = 0.005;  // [m]

struct Peer {
  const char* name;
  Solver solver;
  std::vector<double> steps;
};

/// Largest distance between two paths sampled at the same times [m].
double path_distance(const Response& a, const Response& b) {
  double distance = 0;
  for (std::size_t i = 0; i < std::min(a.items[0].history.size(), b.items[0].history.size()); ++i)
    distance = std::max(
        distance,
        (a.items[0].history[i].displacement - b.items[0].history[i].displacement).head<2>().norm());
  return distance;
}

}  // namespace

void print_peers() {
  fmt::print(
      "The identical scene on three solvers: rigid treads without scrub, casters at 10, 100, 200 "
      "and\n"
      "300 degrees, a 0.4 g three-component motion; distance of the path from the converged one "
      "over\n"
      "{} s, mean of three records; speed on one core, best of three runs\n",
      kDuration);
  constexpr unsigned kRecords[] = {1, 2, 3};
  Scene scene = trolley({10, 100, 200, 300});
  make_rigid(scene, 3e7, 1e7);
  const Scene ours = scene;
  make_rigid(scene, 3e8, 1e8);
  RunOptions settings{{.duration = kDuration, .history_step = kSampling}};

  std::vector<Response> references;
  double peers_apart = 0;
  for (unsigned record : kRecords) {
    const FloorMotion floor = shaking(record, 0.4);
    settings.solver = Solver::kImplicit;
    settings.time_step = 6.25e-5;
    references.push_back(gurney::run(scene, floor, settings));
    settings.solver = Solver::kBulletDantzig;
    settings.time_step = 2.5e-4;
    peers_apart = std::max(peers_apart,
                           path_distance(references.back(), gurney::run(scene, floor, settings)));
  }
  fmt::print("two independent solvers at their finest step are {:.1f} mm apart\n",
             1e3 * peers_apart);
  fmt::print("{:>16} {:>8} {:>12} {:>9} {:>10}\n", "solver", "dt ms", "distance mm", "x real",
             "us a step");
  const Peer peers[] = {
      {"implicit", Solver::kImplicit, {0.01, 0.005, 0.004, 0.0025, 0.00125}},
      {"bullet-dantzig", Solver::kBulletDantzig, {0.01, 0.005, 0.004, 0.0025, 0.00125, 0.000625}},
      {"bullet", Solver::kBullet, {0.005, 0.0025, 0.00125, 0.000625, 0.00025}}};
  double our_speed = 0;
  for (const Peer& peer : peers) {
    std::optional<double> best_speed;
    double nearest = 1e300, nearest_speed = 0;
    for (double step : peer.steps) {
      settings.solver = peer.solver;
      settings.time_step = step;
      double distance = 0, seconds = 0;
      long steps = 0;
      for (std::size_t i = 0; i < std::size(kRecords); ++i) {
        const FloorMotion floor = shaking(kRecords[i], 0.4);
        settings.history_step = kSampling;
        const Scene& mine = peer.solver == Solver::kImplicit ? ours : scene;
        distance += path_distance(references[i], gurney::run(mine, floor, settings)) /
                    static_cast<double>(std::size(kRecords));
        settings.history_step = 0;
        const Timed run = timed(mine, floor, settings, 3);
        seconds += run.seconds;
        steps += run.response.quality.steps;
      }
      const double speed = kDuration * static_cast<double>(std::size(kRecords)) / seconds;
      fmt::print("{:>16} {:>8.3g} {:>12.2f} {:>9.0f} {:>10.1f}\n", peer.name, 1e3 * step,
                 1e3 * distance, speed, 1e6 * seconds / static_cast<double>(steps));
      std::fflush(stdout);
      if (distance < nearest) {
        nearest = distance;
        nearest_speed = speed;
      }
      if (distance <= kPathTolerance && (!best_speed || speed > *best_speed)) best_speed = speed;
    }
    if (peer.solver == Solver::kImplicit) our_speed = best_speed.value_or(0);
    if (best_speed) {
      fmt::print("{:>16} within 5 mm: {:.0f} x real time; Gurney is {:.1f} times as fast\n",
                 peer.name, *best_speed, our_speed / *best_speed);
    } else {
      fmt::print(
          "{:>16} does not come within 5 mm; {:.0f} mm at {:.0f} x real time is its nearest, "
          "Gurney "
          "is {:.0f} "
          "times as fast\n",
          peer.name, 1e3 * nearest, nearest_speed, our_speed / nearest_speed);
    }
  }
  fmt::print("\n");
}

}  // namespace gurney::benchmark
