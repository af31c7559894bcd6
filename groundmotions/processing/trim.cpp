#include "groundmotions/processing/trim.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/error.h"

namespace gurney {

TimeInterval significant_interval(double time_step, const Eigen::VectorXd& acceleration,
                                  double from, double to) {
  require(from >= 0 && from < to && to <= 1,
          fmt::format("shares of the Husid curve must be 0 <= from < to <= 1, got {:g} and {:g}",
                      from, to));
  Eigen::VectorXd husid = Eigen::VectorXd::Zero(acceleration.size());
  for (Eigen::Index i = 1; i < husid.size(); ++i) {
    const double a0 = acceleration[i - 1], a1 = acceleration[i];
    husid[i] = husid[i - 1] + (a0 * a0 + a0 * a1 + a1 * a1) / 3;
  }
  require(husid.size() > 0 && husid[husid.size() - 1] > 0,
          "a motion that is all zero has no significant duration");
  const auto time_of = [&](double share) {
    const double wanted = share * husid[husid.size() - 1];
    const auto above = std::lower_bound(husid.begin(), husid.end(), wanted);
    if (above == husid.begin()) return 0.0;
    const double before = *(above - 1);
    return time_step *
           (static_cast<double>(above - husid.begin() - 1) + (wanted - before) / (*above - before));
  };
  return {time_of(from), time_of(to)};
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

}  // namespace gurney
