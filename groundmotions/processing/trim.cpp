#include "groundmotions/processing/trim.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/error.h"
#include "groundmotions/measures/cumulative.h"

namespace gurney::groundmotions {

TimeInterval significant_interval(double time_step, const Eigen::VectorXd& acceleration,
                                  double from, double to) {
  require(from >= 0 && from < to && to <= 1,
          fmt::format("shares of the Husid curve must be 0 <= from < to <= 1, got {:g} and {:g}",
                      from, to));
  const SignificantPart part = significant_part(time_step, acceleration, from, to);
  require(part.end > part.begin, "a motion that is all zero has no significant duration");
  return {part.begin, part.end};
}

SampleRange samples_within(const TimeInterval& interval, double time_step, Eigen::Index samples) {
  require(interval.from < interval.to,
          fmt::format("a part of a record must end after it begins, got {:g} to {:g} s",
                      interval.from, interval.to));
  constexpr double kSlack = 1e-6;  // of a step
  const double end = static_cast<double>(samples - 1);
  const double first = std::max(std::floor(interval.from / time_step + kSlack), 0.0);
  const double last = std::min(std::ceil(interval.to / time_step - kSlack), end);
  require(last > first, fmt::format("the record is from 0 to {:g} s long, nothing of it is within "
                                    "{:g} to {:g} s",
                                    end * time_step, interval.from, interval.to));
  return {static_cast<Eigen::Index>(first), static_cast<Eigen::Index>(last - first) + 1};
}

Eigen::VectorXd tapered(double time_step, const Eigen::VectorXd& acceleration, double start,
                        double end) {
  const Eigen::Index last = acceleration.size() - 1;
  const double duration = time_step * static_cast<double>(last);
  require(start >= 0 && end >= 0 && start + end <= duration * (1 + 1e-12),
          fmt::format("tapers must be >= 0 s and together at most the record, {:g} s, got {:g} and "
                      "{:g} s",
                      duration, start, end));
  const auto weight = [](double time, double length) {
    return (1 - std::cos(std::numbers::pi * time / length)) / 2;
  };
  Eigen::VectorXd result = acceleration;
  for (Eigen::Index i = 0; i <= last; ++i) {
    const double time = time_step * static_cast<double>(i);
    if (time >= start) break;
    result[i] *= weight(time, start);
  }
  for (Eigen::Index i = 0; i <= last; ++i) {
    const double time = time_step * static_cast<double>(i);
    if (time >= end) break;
    result[last - i] *= weight(time, end);
  }
  return result;
}

}  // namespace gurney::groundmotions
