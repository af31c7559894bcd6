#include "studies/analysis/demand_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "engine/base/error.h"
#include "studies/statistics/quantiles.h"

namespace gurney::study {
namespace {

std::string item_of(const NamedDemand& demand) {
  const Quantity& of = demand.quantity;
  return of.part.empty() ? of.item : of.item + "/" + of.part;
}

DemandRuns& place_for(std::vector<DemandRuns>& all, const DemandRuns& wanted) {
  for (DemandRuns& each : all)
    if (each.item == wanted.item && each.column == wanted.column) return each;
  all.push_back(wanted);
  return all.back();
}

std::size_t nearest(const std::vector<double>& levels, double value) {
  const auto closer = [value](double a, double b) {
    return std::abs(a - value) < std::abs(b - value);
  };
  return static_cast<std::size_t>(std::ranges::min_element(levels, closer) - levels.begin());
}

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

IdaCurve curve_of(std::vector<DemandRun> runs) {
  std::ranges::stable_sort(runs, {}, &DemandRun::im);
  IdaCurve curve{{0}, {0}};
  for (const DemandRun& run : runs) {
    if (run.overturned) {
      const double below = curve.im.back();
      curve.capacity = below > 0 ? std::sqrt(below * run.im) : run.im;
      break;
    }
    curve.im.push_back(run.im);
    curve.demand.push_back(run.demand);
  }
  return curve;
}

}  // namespace

std::vector<DemandRuns> demand_runs(const StudyData& data,
                                    const std::vector<std::size_t>& configurations,
                                    const std::string& demand, const RunMeasure& measure) {
  std::vector<DemandRuns> all;
  const RunLevels levels = run_levels(data);
  const std::vector<double> cases = data.file().numbers("runs/analysis_case");
  for (const std::size_t configuration : configurations)
    for (const NamedDemand& named : demands_named(data, configuration, {demand})) {
      const std::vector<std::size_t>& runs = data.runs_of(configuration);
      const std::vector<double> values = values_of_runs(data, named, runs);
      const NamedDemand fall{
          "", "s", {Quantity::Of::kItem, "time_of_overturning", named.quantity.item, ""}};
      const std::vector<double> falls = values_of_runs(data, fall, runs);
      DemandRuns::Configuration found{data.configurations()[configuration], {}};
      for (std::size_t i = 0; i < runs.size(); ++i) {
        const std::size_t run = runs[i];
        if (!std::isfinite(values[i]) || !(measure.values[run] > 0)) continue;
        found.runs.push_back({measure.values[run], values[i], falls[i] >= 0, data.record_of(run),
                              static_cast<std::size_t>(cases[run]),
                              levels.texts[levels.of_run[run]], run});
      }
      if (found.runs.empty()) continue;
      const DemandRuns place{item_of(named), named.quantity.column, data.units().of(named.units),
                             measure.name, report_unit(data, measure)};
      place_for(all, place).configurations.push_back(std::move(found));
    }
  require(!all.empty(), data.file().path() + ": no run has " + demand + " and " + measure.name);
  return all;
}

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

double IdaCurve::demand_at(double intensity) const {
  if (intensity >= capacity) return kInfinity;
  const auto above = std::ranges::lower_bound(im, intensity);
  if (above == im.end()) return std::isfinite(capacity) ? demand.back() : kNaN;
  const auto i = static_cast<std::size_t>(above - im.begin());
  if (i == 0) return demand.front();
  const double share = (intensity - im[i - 1]) / (im[i] - im[i - 1]);
  return demand[i - 1] + share * (demand[i] - demand[i - 1]);
}

std::vector<IdaCurve> ida_curves(const std::vector<DemandRun>& runs) {
  std::map<std::pair<std::size_t, std::size_t>, std::vector<DemandRun>> cases;
  for (const DemandRun& run : runs) cases[{run.record, run.analysis_case}].push_back(run);
  std::vector<IdaCurve> curves;
  for (const auto& [name, of_case] : cases) curves.push_back(curve_of(of_case));
  return curves;
}

double fractile_at(const std::vector<IdaCurve>& curves, double intensity, double fraction) {
  std::vector<double> values;
  for (const IdaCurve& curve : curves)
    if (const double value = curve.demand_at(intensity); !std::isnan(value))
      values.push_back(value);
  if (2 * values.size() < curves.size() || values.empty()) return kNaN;
  return statistics::quantile_of(std::move(values), fraction);
}

}  // namespace gurney::study
