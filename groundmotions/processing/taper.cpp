#include "groundmotions/processing/taper.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "engine/base/error.h"

namespace gurney::groundmotions {

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
