#include "groundmotions/formats/time_column.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/base/error.h"
#include "groundmotions/formats/numbers.h"
#include "groundmotions/record/record.h"

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

double even_step(const std::vector<double>& times, const std::vector<std::size_t>& lines,
                 FileErrors& errors, double rounding) {
  std::vector<double> steps(times.size());
  std::adjacent_difference(times.begin(), times.end(), steps.begin());
  auto sorted = std::vector(steps.begin() + 1, steps.end());
  std::ranges::nth_element(sorted, sorted.begin() + static_cast<long>(sorted.size() / 2));
  const double usual = sorted[sorted.size() / 2];
  if (!is_time_step(usual)) {
    errors.add(lines[1], 1,
               fmt::format("time steps must be in [{:g}, {:g}] s, got {:.9g}", kShortestTimeStep,
                           kLongestTimeStep, usual));
    return usual;
  }
  for (std::size_t i = 1; i < steps.size(); ++i)
    if (!(std::abs(steps[i] - usual) <= 0.5 * usual)) {
      errors.add(lines[i], 1,
                 fmt::format("the time goes from {} to {} s where the step is {:.9g} s",
                             times[i - 1], times[i], usual));
      return usual;
    }
  const double mean = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
  const double step = *number(fmt::format("{:.12g}", mean));
  const auto even = [&](std::size_t i) { return times[0] + static_cast<double>(i) * mean; };
  std::size_t worst = 0;
  for (std::size_t i = 1; i < times.size(); ++i)
    if (!(std::abs(times[i] - even(i)) <= std::abs(times[worst] - even(worst)))) worst = i;
  const double deviation = std::abs(times[worst] - even(worst)) / mean;
  if (!(deviation <= kTimeTolerance + rounding / mean))
    errors.add(lines[worst], 1,
               fmt::format("time {} s is off the even grid ({:.9g} s, step {:.9g} s) by {:.3g} "
                           "of the step, {} is allowed; no other time is farther off",
                           times[worst], even(worst), step, deviation, kTimeTolerance));
  return step;
}

std::string axis_error(const std::vector<double>& values) {
  constexpr std::size_t kFew = 20, kMany = 100;
  constexpr double kLongStep = 0.5, kTolerance = 0.1;
  if (values.size() < kFew) return {};
  const double step = (values.back() - values.front()) / static_cast<double>(values.size() - 1);
  if (!(step > 0) || (step > kLongStep && values.size() < kMany)) return {};
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!(std::abs(values[i] - values[0] - static_cast<double>(i) * step) <= kTolerance * step))
      return {};
  return fmt::format(
      "the numbers rise from {:.9g} to {:.9g} by the same {:.6g}: they are times or indices, no "
      "accelerations",
      values.front(), values.back(), step);
}

std::string late_start(double first_time, double step) {
  if (std::abs(first_time) <= kTimeTolerance * step) return {};
  return fmt::format("the first time is {} s; the motion starts there, at 0 s of the run",
                     first_time);
}

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
