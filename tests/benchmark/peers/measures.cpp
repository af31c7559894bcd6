#include "tests/benchmark/peers/measures.h"

#include <algorithm>
#include <cmath>

#include "engine/base/units.h"

namespace gurney::benchmark {
namespace {

using peers::Path;
using peers::Snapshot;

constexpr Peaks kRest = {1e-3, 0.1 * kRadiansPerDegree, 0.01};
constexpr double kAlike = 0.05;

/// Displacement of the floor over each sampling interval, by Simpson's rule or as the engine's.
std::vector<Vector2> floor_steps(const peers::CrossCheck& check, std::size_t count,
                                 double euler_step) {
  constexpr int kParts = 4;
  const double h = check.sampling / kParts;
  std::vector<Vector2> steps;
  for (std::size_t k = 0; k < count; ++k) {
    Vector3 sum = Vector3::Zero();
    const long parts = euler_step > 0 ? std::lround(check.sampling / euler_step) : 0;
    for (long i = 1; i <= parts; ++i)
      sum += euler_step * check.floor.velocity_at(static_cast<double>(k) * check.sampling +
                                                  static_cast<double>(i) * euler_step);
    for (int i = 0; parts == 0 && i < kParts; ++i) {
      const double t = static_cast<double>(k) * check.sampling + i * h;
      sum += h / 6 *
             (check.floor.velocity_at(t) + 4 * check.floor.velocity_at(t + 0.5 * h) +
              check.floor.velocity_at(t + h));
    }
    steps.push_back(sum.head<2>());
  }
  return steps;
}

double displacement(const Snapshot& at, const Path& path) {
  return (at.place - path[0].place).head<2>().norm();
}

}  // namespace

Peaks peaks_of(const Path& path, const peers::CrossCheck& check, double euler_step) {
  Peaks peaks{};
  for (const Snapshot& at : path) {
    peaks[0] = std::max(peaks[0], displacement(at, path));
    peaks[1] = std::max(peaks[1], at.tilt);
  }
  const std::vector<Vector2> floor = floor_steps(check, path.size() - 1, euler_step);
  for (std::size_t k = 1; k + 1 < path.size(); ++k) {
    const Vector2 change = (path[k + 1].place - 2 * path[k].place + path[k - 1].place).head<2>() +
                           floor[k] - floor[k - 1];
    peaks[2] = std::max(peaks[2], change.norm() / (check.sampling * check.sampling));
  }
  return peaks;
}

std::array<double, 3> relative_errors(const Peaks& a, const Peaks& b) {
  std::array<double, 3> errors{};
  for (std::size_t i = 0; i < 3; ++i)
    errors[i] = std::isfinite(a[i]) ? std::abs(a[i] - b[i]) / std::max(b[i], kRest[i]) : 1e9;
  return errors;
}

double agreement(const Path& a, const Path& b, double sampling) {
  double peak = kRest[0], tilt = kRest[1];
  for (const Snapshot& at : b) {
    peak = std::max(peak, displacement(at, b));
    tilt = std::max(tilt, at.tilt);
  }
  std::size_t k = 0;
  while (k < a.size() && k < b.size() &&
         (a[k].place - b[k].place).head<2>().norm() <= kAlike * peak &&
         std::abs(a[k].tilt - b[k].tilt) <= kAlike * tilt)
    ++k;
  return static_cast<double>(k) * sampling;
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

}  // namespace gurney::benchmark
