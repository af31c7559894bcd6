#include <fmt/core.h>

#include <algorithm>
#include <chrono>

#include "groundmotions/measures/response_spectrum.h"
#include "groundmotions/measures/rotation.h"
#include "groundmotions/measures/summary.h"
#include "groundmotions/synthetic/noise.h"
#include "tests/benchmark/sections.h"

namespace gurney::benchmark {
namespace {

constexpr int kPeriods = 100, kSamples = 4001;
constexpr double kTimeStep = 0.005;

template <class Work>
void print_time(const char* name, Work work) {
  double best = 1e300;
  for (int i = 0; i < 20; ++i) {
    const auto start = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
    best = std::min(best, wall.count());
  }
  fmt::print("  {:<44} {:8.3f} ms {:8.2f} ns per period and sample\n", name, 1e3 * best,
             1e9 * best / kPeriods / (kSamples - 1));
}

}  // namespace

void print_spectra() {
  const groundmotions::Record record =
      groundmotions::white_noise(kTimeStep, {.seed = 1,
                                             .lowest_frequency = 0.1,
                                             .highest_frequency = 20,
                                             .duration = kTimeStep * (kSamples - 1),
                                             .taper = 1,
                                             .peak_acceleration = {3, 3, 2}});
  const double dt = record.time_step();
  const Eigen::VectorXd& h1 = record[groundmotions::Direction::kH1]->acceleration;
  const Eigen::VectorXd& h2 = record[groundmotions::Direction::kH2]->acceleration;
  const Eigen::VectorXd periods = groundmotions::logarithmic_periods(0.01, 10, kPeriods);
  fmt::print("\nResponse spectra: {} periods from 0.01 to 10 s, {} samples of {} s, one core\n",
             kPeriods, kSamples, dt);
  double sink = 0;
  print_time("peaks at the samples",
             [&] { sink += groundmotions::response_spectrum(dt, h1, periods).displacement.sum(); });
  print_time("peaks between samples", [&] {
    sink += groundmotions::response_spectrum(dt, h1, periods, 0.05,
                                             groundmotions::PeakAt::kBetweenSamples)
                .displacement.sum();
  });
  print_time("RotD00, RotD50 and RotD100 of two components",
             [&] { sink += groundmotions::rotated_spectrum(dt, h1, h2, periods).rotd50.sum(); });
  const auto start = std::chrono::steady_clock::now();
  sink += summary(record).rows[0].values[0].second;
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  fmt::print("  {:<44} {:8.1f} ms (checksum {:.3g})\n", "all measures of three components",
             1e3 * wall.count(), sink);
}

}  // namespace gurney::benchmark
