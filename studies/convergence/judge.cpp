#include "studies/convergence/judge.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace gurney::study {
namespace {

/// Values by factor of what was varied, the job's own among them.
std::map<double, double> along(const ConvergedNumber& number, const std::vector<Variant>& variants,
                               Varied wanted) {
  std::map<double, double> values{{1.0, number.values.front()}};
  for (std::size_t i = 0; i < variants.size(); ++i)
    if (variants[i].varied == wanted) values[variants[i].factor] = number.values[i];
  return values;
}

/// Largest change over factors from `low` to `high`.
double largest_change(const std::map<double, double>& values, double low, double high,
                      double smallest) {
  double largest = 0;
  for (const auto& [factor, value] : values)
    if (factor >= low && factor <= high)
      largest = std::max(largest, relative_change(values.at(1.0), value, smallest));
  return largest;
}

}  // namespace

double relative_change(double a, double b, double smallest) {
  const double difference = std::abs(a - b);
  return difference <= smallest ? 0 : difference / std::max(std::abs(a), std::abs(b));
}

void judge(ConvergedNumber& number, const std::vector<Variant>& variants,
           const SimulationSettings& settings, double tolerance, double smallest) {
  const auto step = along(number, variants, Varied::kTimeStep);
  const double whole = step.at(1), half = step.at(0.5), quarter = step.at(0.25),
               eighth = step.at(0.125);
  number.change = relative_change(whole, eighth, smallest);
  const double first = std::abs(whole - half), second = std::abs(half - quarter),
               third = std::abs(quarter - eighth);
  number.order = first > 0 && second > 0 ? std::log2(first / second)
                                         : std::numeric_limits<double>::quiet_NaN();
  number.solver_change =
      largest_change(along(number, variants, Varied::kSolverTolerance), 0, 1, smallest);
  number.stiffness_change =
      largest_change(along(number, variants, Varied::kTreadStiffness), 0.5, 2, smallest);
  number.step_needed = settings.time_step;
  if (number.change <= tolerance) {
    number.step = StepVerdict::kConverged;
  } else if (std::abs(whole - eighth) <= 0.5 * number.scatter) {
    number.step = StepVerdict::kScattered;
  } else if (second <= 0.75 * first && third <= 0.75 * second) {
    number.step = StepVerdict::kConverging;
    const double order = std::clamp(number.order, 0.5, 2.0);
    number.step_needed *= std::pow(tolerance / number.change, 1 / order);
  } else {
    number.step = StepVerdict::kSensitive;
  }
}

}  // namespace gurney::study
