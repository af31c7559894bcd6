#include "studies/analysis/ida_curves.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace gurney::study {
namespace {

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
  std::ranges::sort(values);
  const double place = fraction * static_cast<double>(values.size()) - 0.5;
  const double last = static_cast<double>(values.size() - 1);
  const double low = std::clamp(std::floor(place), 0.0, last), high = std::min(low + 1, last);
  const double share = std::clamp(place - low, 0.0, 1.0);
  const double a = values[static_cast<std::size_t>(low)],
               b = values[static_cast<std::size_t>(high)];
  if (share == 0) return a;
  return std::isinf(b) ? kInfinity : a + share * (b - a);
}

}  // namespace gurney::study
