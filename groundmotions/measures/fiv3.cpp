#include "groundmotions/measures/fiv3.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <vector>

#include "engine/base/error.h"

namespace gurney::groundmotions {
namespace {

/// One pass of a second-order low-pass Butterworth filter, from rest: the bilinear transform with
/// the corner kept in place (Oppenheim & Schafer, Discrete-Time Signal Processing, ch. 7).
/// @param corner  over the sampling rate, in (0, 0.5)
template <class Iterator>
void low_pass(Iterator begin, Iterator end, double corner) {
  const double k = std::tan(std::numbers::pi * corner);
  const double norm = 1 / (1 + std::numbers::sqrt2 * k + k * k);
  const double b = k * k * norm;
  const double a1 = 2 * (k * k - 1) * norm, a2 = (1 - std::numbers::sqrt2 * k + k * k) * norm;
  double x1 = 0, x2 = 0, y1 = 0, y2 = 0;
  for (; begin != end; ++begin) {
    const double x = *begin, y = b * (x + 2 * x1 + x2) - a1 * y1 - a2 * y2;
    x2 = x1, x1 = x;
    y2 = y1, y1 = y;
    *begin = y;
  }
}

/// Forward and backward; what the forward pass leaves after the end is kept for the backward pass.
std::vector<double> filtered(const Eigen::VectorXd& acceleration, double corner) {
  constexpr double kRinging = 6;  // cycles of the corner after which exp(-2 pi 6 / sqrt(2)) = 3e-12
  std::vector<double> result(acceleration.begin(), acceleration.end());
  result.resize(result.size() + static_cast<std::size_t>(std::ceil(kRinging / corner)), 0.0);
  low_pass(result.begin(), result.end(), corner);
  low_pass(result.rbegin(), result.rend(), corner);
  result.resize(static_cast<std::size_t>(acceleration.size()));
  return result;
}

/// V at every sample where the window, `window` samples long, fits into the record.
std::vector<double> incremental_velocity(const std::vector<double>& a, double time_step,
                                         double window) {
  std::vector<double> velocity(a.size(), 0.0);
  for (std::size_t i = 1; i < a.size(); ++i)
    velocity[i] = velocity[i - 1] + time_step / 2 * (a[i - 1] + a[i]);
  const auto whole = static_cast<std::size_t>(window);
  const double part = window - static_cast<double>(whole);
  std::vector<double> result;
  for (std::size_t i = 0; static_cast<double>(i) + window <= static_cast<double>(a.size() - 1);
       ++i) {
    const std::size_t end = i + whole;
    double at_end = velocity[end];
    if (part > 0) at_end += time_step * part * (a[end] + part / 2 * (a[end + 1] - a[end]));
    result.push_back(at_end - velocity[i]);
  }
  return result;
}

/// The sum of the three highest local maxima above zero; a plateau is one maximum.
double three_highest(const std::vector<double>& v) {
  std::vector<double> maxima;
  bool rises = false;
  for (std::size_t i = 1; i < v.size(); ++i) {
    if (v[i] < v[i - 1] && rises && v[i - 1] > 0) maxima.push_back(v[i - 1]);
    if (v[i] != v[i - 1]) rises = v[i] > v[i - 1];
  }
  const auto end = maxima.begin() + std::min<std::ptrdiff_t>(3, std::ssize(maxima));
  std::partial_sort(maxima.begin(), end, maxima.end(), std::greater<>());
  return std::accumulate(maxima.begin(), end, 0.0);
}

}  // namespace

double fiv3(double time_step, const Eigen::VectorXd& acceleration, double period,
            const Fiv3Settings& settings) {
  assert(time_step > 0);
  const double window = settings.window * period / time_step;
  const double corner = settings.cutoff * time_step / period;
  const double duration = time_step * static_cast<double>(acceleration.size() - 1);
  require(corner > 0 && corner < 0.5,
          fmt::format("FIV3({0:g}): the period must be above {1:g} s, as the filter's corner must "
                      "lie below half the sampling rate",
                      period, 2 * settings.cutoff * time_step));
  require(window * time_step <= duration,
          fmt::format("FIV3({0:g}): the period must be at most {1:g} s, as a window of {2:g} times "
                      "the period must fit into the record of {3:g} s",
                      period, duration / settings.window, settings.window, duration));
  std::vector<double> v = incremental_velocity(filtered(acceleration, corner), time_step, window);
  const double highest = three_highest(v);
  for (double& each : v) each = -each;
  return std::max(highest, three_highest(v));
}

}  // namespace gurney::groundmotions
