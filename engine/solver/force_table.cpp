#include "engine/solver/force_table.h"

#include <algorithm>
#include <utility>

namespace gurney {

ForceTable::ForceTable(std::vector<double> time, std::vector<double> force)
    : time_(std::move(time)), force_(std::move(force)), integral_(time_.size()) {
  for (std::size_t i = 1; i < time_.size(); ++i)
    integral_[i] = integral_[i - 1] + integral_on_line(i, time_[i]);
}

double ForceTable::on_line(std::size_t i, double time) const {
  const double t0 = time_[i - 1], f0 = force_[i - 1];
  return f0 + (force_[i] - f0) * (time - t0) / (time_[i] - t0);
}

double ForceTable::integral_on_line(std::size_t i, double end) const {
  return 0.5 * (force_[i - 1] + on_line(i, end)) * (end - time_[i - 1]);
}

std::size_t ForceTable::point_at(double time) const {
  return static_cast<std::size_t>(std::lower_bound(time_.begin(), time_.end(), time) -
                                  time_.begin());
}

double ForceTable::value(double time) const {
  if (time_.size() < 2 || time < time_.front() || time > time_.back()) return 0;
  return on_line(std::max<std::size_t>(point_at(time), 1), time);
}

double ForceTable::integral(double time) const {
  const std::size_t i = point_at(time);
  if (i == 0) return 0;
  return i == time_.size() ? integral_.back() : integral_[i - 1] + integral_on_line(i, time);
}

}  // namespace gurney
