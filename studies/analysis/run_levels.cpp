#include "studies/analysis/run_levels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace gurney::study {
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
  levels.traced = plan.kind == IntensityPlan::Kind::kIda;
  if (levels.traced) {
    levels.texts = {"all"};
    levels.of_run.assign(data.file().runs(), 0);
    return levels;
  }
  const bool factors = plan.kind == IntensityPlan::Kind::kScales;
  const auto of_runs = data.file().numbers(factors ? "runs/scale" : "runs/intensity");
  std::set<double> stated(plan.levels.begin(), plan.levels.end());
  if (plan.more_stages > 0) stated.insert(of_runs.begin(), of_runs.end());
  const std::vector<double> values(stated.begin(), stated.end());
  const ReportUnit unit = data.units().chosen()
                              ? data.units().of(data.file().text_attribute("intensity_units"))
                              : ReportUnit{plan.unit, plan.unit_in_si};
  for (const double level : values)
    levels.texts.push_back(factors ? fmt::format("x {:g}", level)
                                   : fmt::format("{:g} {}", level / unit.in_si, unit.name));
  for (const double value : of_runs) levels.of_run.push_back(nearest(values, value));
  return levels;
}

}  // namespace gurney::study
