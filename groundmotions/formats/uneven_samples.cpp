#include "groundmotions/formats/uneven_samples.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/error.h"

namespace gurney::groundmotions {

namespace {

/// Share of a step: a last time that misses the grid by less is on it.
constexpr double kGridTolerance = 1e-6;
constexpr double kMaxSamples = 1e7;

void check(const std::vector<double>& times, const std::vector<double>& values, double time_step) {
  require(times.size() >= 2 && times.size() == values.size(),
          fmt::format("{} times and {} values are no record", times.size(), values.size()));
  const auto drop = std::ranges::adjacent_find(times, [](double a, double b) { return !(a <= b); });
  if (drop != times.end())
    throw Error(fmt::format("time {} of {} decreases: {} s after {} s", drop - times.begin() + 2,
                            times.size(), *(drop + 1), *drop));
  const double duration = times.back() - times.front();
  require(spacing_of(times).largest <= kLongestGap,
          fmt::format("times that follow each other are up to {:g} s apart, {} s is allowed",
                      spacing_of(times).largest, kLongestGap));
  require(time_step > 0 && duration >= time_step && duration <= kMaxSamples * time_step,
          fmt::format("samples over {} s cannot be brought to a time step of {} s", duration,
                      time_step));
}

}  // namespace

Spacing spacing_of(const std::vector<double>& times) {
  Spacing result{times[1] - times[0], times[1] - times[0]};
  for (std::size_t i = 2; i < times.size(); ++i) {
    result.smallest = std::min(result.smallest, times[i] - times[i - 1]);
    result.largest = std::max(result.largest, times[i] - times[i - 1]);
  }
  return result;
}

Eigen::VectorXd evenly_spaced(const std::vector<double>& times, const std::vector<double>& values,
                              double time_step) {
  check(times, values, time_step);
  const double steps = (times.back() - times.front()) / time_step;
  Eigen::VectorXd result(static_cast<Eigen::Index>(std::floor(steps + kGridTolerance)) + 1);
  std::size_t next = 1;
  for (Eigen::Index i = 0; i < result.size(); ++i) {
    const double time = std::min(times.front() + static_cast<double>(i) * time_step, times.back());
    while (next + 1 < times.size() && times[next] <= time) ++next;
    const double gap = times[next] - times[next - 1];
    const double share = gap > 0 ? (time - times[next - 1]) / gap : 1;
    result[i] = values[next - 1] + share * (values[next] - values[next - 1]);
  }
  return result;
}

std::string uneven_warning(const std::vector<double>& times, double time_step) {
  const Spacing spacing = spacing_of(times);
  return fmt::format(
      "the samples are {:.4g} to {:.4g} s apart; they were brought to even steps of {} s by "
      "straight lines between them ({} samples before)",
      spacing.smallest, spacing.largest, time_step, times.size());
}

}  // namespace gurney::groundmotions
