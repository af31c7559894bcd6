#include "groundmotions/measures/fiv3.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/base/error.h"

namespace gurney {

namespace {

constexpr double kWindow = 0.7, kCorner = 0.85;
constexpr std::size_t kPeaks = 3;

/// Second-order Butterworth low-pass by the bilinear transform, prewarped, forward, from rest.
Eigen::VectorXd low_passed(double time_step, const Eigen::VectorXd& x, double corner) {
  const double k = std::tan(std::numbers::pi * corner * time_step);
  const double norm = 1 / (1 + std::numbers::sqrt2 * k + k * k);
  const double b = k * k * norm;
  const double a1 = 2 * (k * k - 1) * norm, a2 = (1 - std::numbers::sqrt2 * k + k * k) * norm;
  Eigen::VectorXd y(x.size());
  double x1 = 0, x2 = 0, y1 = 0, y2 = 0;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    y[i] = b * (x[i] + 2 * x1 + x2) - a1 * y1 - a2 * y2;
    x2 = x1;
    x1 = x[i];
    y2 = y1;
    y1 = y[i];
  }
  return y;
}

/// Sum of the three largest local maxima above zero.
double sum_of_peaks(const Eigen::VectorXd& values) {
  std::vector<double> peaks;
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const bool rises = i == 0 || values[i] > values[i - 1];
    const bool falls = i + 1 == values.size() || values[i] >= values[i + 1];
    if (rises && falls && values[i] > 0) peaks.push_back(values[i]);
  }
  const std::size_t count = std::min(kPeaks, peaks.size());
  std::ranges::partial_sort(peaks, peaks.begin() + static_cast<std::ptrdiff_t>(count),
                            std::greater<>());
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) sum += peaks[i];
  return sum;
}

}  // namespace

double fiv3(double time_step, const Eigen::VectorXd& acceleration, double period) {
  require(period > time_step && std::isfinite(period),
          fmt::format("FIV3 needs a period longer than the time step of {} s, got {}", time_step,
                      period));
  const double corner = kCorner / period;
  const Eigen::VectorXd filtered =
      corner < 0.5 / time_step ? low_passed(time_step, acceleration, corner) : acceleration;
  const auto window = std::max<Eigen::Index>(
      1, static_cast<Eigen::Index>(std::lround(kWindow * period / time_step)));
  if (filtered.size() <= window) return 0;
  Eigen::VectorXd velocity(filtered.size());
  velocity[0] = 0;
  for (Eigen::Index i = 1; i < filtered.size(); ++i)
    velocity[i] = velocity[i - 1] + time_step * (filtered[i - 1] + filtered[i]) / 2;
  const Eigen::Index count = filtered.size() - window;
  const Eigen::VectorXd increment = velocity.tail(count) - velocity.head(count);
  return std::max(sum_of_peaks(increment), sum_of_peaks(-increment));
}

}  // namespace gurney
