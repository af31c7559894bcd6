#include "studies/statistics/intensity_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "engine/base/error.h"
#include "studies/statistics/censored_normal.h"
#include "studies/statistics/quantiles.h"
#include "studies/statistics/special.h"

namespace gurney::statistics {
namespace {

constexpr std::size_t kFewestRuns = 5;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// p of no dependence of the points' demand on `property` besides ln im.
double sufficiency(const std::vector<CloudPoint>& points, const std::vector<double>& property) {
  std::vector<CloudPoint> known;
  std::vector<double> values;
  std::set<std::size_t> records;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!std::isfinite(property[i])) continue;
    known.push_back(points[i]);
    values.push_back(property[i]);
    records.insert(points[i].group);
  }
  if (known.size() < kFewestRuns) return kNan;
  const Moments moments = moments_of(values);
  if (!(moments.variance > 0)) return kNan;
  const auto n = static_cast<Eigen::Index>(known.size());
  Eigen::MatrixXd design(n, 3);
  std::vector<CensoredValue> demands;
  std::vector<std::size_t> groups;
  for (Eigen::Index i = 0; i < n; ++i) {
    const CloudPoint& point = known[static_cast<std::size_t>(i)];
    const double value = values[static_cast<std::size_t>(i)];
    design.row(i) << 1, std::log(point.im), (value - moments.mean) / std::sqrt(moments.variance);
    demands.push_back(log_demand(point));
    groups.push_back(point.group);
  }
  const CensoredNormalFit with = fit_censored_normal(design, demands, groups);
  if (!with.found) return kNan;
  if (records.size() == known.size()) {
    const CensoredNormalFit without = fit_censored_normal(design.leftCols(2), demands, groups);
    if (!without.found) return kNan;
    const double ratio = std::max(0.0, 2 * (with.log_likelihood - without.log_likelihood));
    const double count = static_cast<double>(n);
    return fisher_survival(std::expm1(ratio / count) * (count - 3), 1, count - 3);
  }
  if (records.size() < kFewestRuns) return kNan;
  const double t = with.coefficients[2] / std::sqrt(with.cluster_covariance(2, 2));
  return 2 * student_survival(std::abs(t), static_cast<double>(records.size() - 1));
}

}  // namespace

std::vector<IntensityRow> compare_intensities(const std::vector<CloudPoint>& demands,
                                              const std::vector<NamedValues>& measures,
                                              const std::vector<NamedValues>& properties) {
  for (const auto* columns : {&measures, &properties})
    for (const NamedValues& column : *columns)
      require(column.values.size() == demands.size(),
              fmt::format("{} has {} values for {} runs", column.name, column.values.size(),
                          demands.size()));
  std::vector<IntensityRow> rows;
  for (const NamedValues& measure : measures) {
    std::vector<CloudPoint> points;
    std::vector<std::vector<double>> known(properties.size());
    for (std::size_t i = 0; i < demands.size(); ++i) {
      if (!(measure.values[i] > 0) || !std::isfinite(measure.values[i])) continue;
      points.push_back(demands[i]);
      points.back().im = measure.values[i];
      for (std::size_t j = 0; j < properties.size(); ++j)
        known[j].push_back(properties[j].values[i]);
    }
    const CloudFit fit = fit_cloud(points);
    IntensityRow row;
    row.name = measure.name;
    row.status = fit.status;
    row.runs = static_cast<int>(points.size());
    row.left_out = static_cast<int>(demands.size() - points.size());
    row.sufficiency.assign(properties.size(), kNan);
    if (fit.status == CloudStatus::kFitted) {
      row.efficiency = fit.sigma;
      row.practicality = fit.b;
      row.proficiency = fit.sigma / std::abs(fit.b);
      row.r_squared = fit.r_squared;
      row.log_likelihood = fit.log_likelihood;
      for (std::size_t j = 0; j < properties.size(); ++j)
        row.sufficiency[j] = sufficiency(points, known[j]);
    }
    rows.push_back(row);
  }
  return rows;
}

}  // namespace gurney::statistics
