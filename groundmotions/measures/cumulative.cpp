#include "groundmotions/measures/cumulative.h"

#include <cassert>
#include <cmath>
#include <numbers>

#include "engine/base/units.h"

namespace gurney::groundmotions {

double arias_intensity(double time_step, const Eigen::VectorXd& acceleration, Rule rule) {
  double sum = 0;
  for (Eigen::Index i = 1; i < acceleration.size(); ++i) {
    const double a = acceleration[i - 1], b = acceleration[i];
    sum += rule == Rule::kTrapezoid ? (a * a + b * b) / 2 : (a * a + a * b + b * b) / 3;
  }
  return std::numbers::pi / (2 * kStandardGravity) * time_step * sum;
}

double cumulative_absolute_velocity(double time_step, const Eigen::VectorXd& acceleration,
                                    Rule rule) {
  double sum = 0;
  for (Eigen::Index i = 1; i < acceleration.size(); ++i) {
    const double a = std::abs(acceleration[i - 1]), b = std::abs(acceleration[i]);
    const bool crosses = acceleration[i - 1] * acceleration[i] < 0;
    // Two triangles where the line crosses zero.
    sum += rule == Rule::kExact && crosses ? (a * a + b * b) / (a + b) : a + b;
  }
  return time_step / 2 * sum;
}

SignificantPart significant_part(double time_step, const Eigen::VectorXd& acceleration, double from,
                                 double to) {
  assert(time_step > 0 && from >= 0 && from <= to && to <= 1);
  Eigen::VectorXd husid = Eigen::VectorXd::Zero(acceleration.size());
  for (Eigen::Index i = 1; i < husid.size(); ++i)
    husid[i] = husid[i - 1] + acceleration[i - 1] * acceleration[i - 1] +
               acceleration[i] * acceleration[i];
  const double total = husid.size() ? husid[husid.size() - 1] : 0;
  if (!(total > 0)) return {};
  const auto reaches = [&](double fraction) {
    const double level = fraction * total;
    Eigen::Index i = 0;
    while (husid[i] < level) ++i;
    if (i == 0) return 0.0;
    return time_step *
           (static_cast<double>(i - 1) + (level - husid[i - 1]) / (husid[i] - husid[i - 1]));
  };
  return {reaches(from), reaches(to)};
}

}  // namespace gurney::groundmotions
