#include "studies/analysis/run_levels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gurney {
namespace {

std::size_t nearest(const std::vector<double>& levels, double value) {
  const auto closer = [value](double a, double b) {
    return std::abs(a - value) < std::abs(b - value);
  };
  return static_cast<std::size_t>(std::ranges::min_element(levels, closer) - levels.begin());
}

}  // namespace

RunLevels run_levels(const StudyData& data) {
  const IntensityPlan& plan = data.study().intensity;
  RunLevels levels;
  levels.hunted = plan.kind == IntensityPlan::Kind::kHunt;
  if (levels.hunted) {
    levels.texts = {"all"};
    levels.of_run.assign(data.file().runs(), 0);
    return levels;
  }
  const bool factors = plan.kind == IntensityPlan::Kind::kScales;
  for (const double level : plan.levels)
    levels.texts.push_back(factors ? fmt::format("x {:g}", level)
                                   : fmt::format("{:g} {}", level / plan.unit_in_si, plan.unit));
  for (const double value : data.file().numbers(factors ? "runs/scale" : "runs/intensity"))
    levels.of_run.push_back(nearest(plan.levels, value));
  return levels;
}

}  // namespace gurney
