#include "studies/analysis/site_rate.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "studies/statistics/rate_interval.h"

namespace gurney::study {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::string intensity(const ReportUnit& unit, double im) {
  return fmt::format("{:.3g}{}{}", im / unit.in_si, unit.name == "1" ? "" : " ",
                     unit.name == "1" ? "" : unit.name);
}

}  // namespace

bool SiteRate::is_supported() const {
  return std::isfinite(rate) && complete() && share_below <= kLargestShare &&
         share_above <= kLargestShare;
}

SiteRate site_rate(const statistics::LognormalCurve& curve, const statistics::FragilityBand& band,
                   const CurveAudit& audit, const statistics::HazardCurve& hazard) {
  SiteRate rate;
  static_cast<statistics::MeanRate&>(rate) = statistics::mean_rate(curve, hazard);
  rate.lowest = audit.lowest;
  rate.highest = audit.highest;
  rate.of_lowest = hazard.rate(audit.lowest);
  rate.has_interval = !band.outline.empty();
  rate.interval = statistics::rate_interval(band.outline, hazard);
  if (rate.of_lowest && rate.interval.high > *rate.of_lowest) rate.interval.high = kInfinity;
  if (rate.of_lowest && rate.rate > *rate.of_lowest) {
    rate.rate = std::numeric_limits<double>::quiet_NaN();
    rate.share_below = 1;
    return rate;
  }
  if (!(rate.rate > 0)) return rate;
  const double up_to_highest = statistics::rate_between(curve, hazard, 0, audit.highest);
  rate.share_below = statistics::rate_between(curve, hazard, 0, audit.lowest) / rate.rate;
  // The end of a table counts as above the highest level if the table reaches beyond it.
  if (hazard.pieces().back().high > audit.highest)
    rate.share_above = std::max(0.0, 1 - up_to_highest / rate.rate);
  return rate;
}

std::string rate_interval_text(const SiteRate& rate, std::size_t records) {
  const statistics::Interval of =
      rate.has_interval ? rate.interval : statistics::Interval{0, kInfinity};
  return interval_text(of, 1, 3, records);
}

std::string rate_text(const SiteRate& rate, std::size_t records) {
  if (std::isnan(rate.rate)) return "no annual rate";
  return fmt::format("{:.3g} times a year (95 %: {}), {:.2g} % in 50 years", rate.rate,
                     rate_interval_text(rate, records),
                     100 * statistics::probability_in(50, rate.rate));
}

std::vector<std::string> cautions(const SiteRate& rate, const ReportUnit& unit) {
  std::vector<std::string> all;
  if (std::isnan(rate.rate))
    return {fmt::format(
        "the curve and the hazard give more than the rate of motions above the lowest analysed "
        "intensity, {:.3g} a year at {}: the runs do not support a rate; analyse weaker motions",
        *rate.of_lowest, intensity(unit, rate.lowest))};
  if (rate.share_below > kLargestShare)
    all.push_back(
        fmt::format("{:.0f} % of the rate is from motions below the lowest analysed "
                    "intensity, {}, where only the form of the curve counts",
                    100 * rate.share_below, intensity(unit, rate.lowest)));
  if (rate.share_above > kLargestShare)
    all.push_back(
        fmt::format("{:.0f} % of the rate is from motions above the highest analysed "
                    "intensity, {}, where only the form of the curve counts",
                    100 * rate.share_above, intensity(unit, rate.highest)));
  if (!rate.complete())
    all.push_back(
        fmt::format("the hazard curve is too short: stronger motions add at most {:.2g} a year, "
                    "and P is {:.2g} at its lower end",
                    rate.most_above, rate.below));
  return all;
}

}  // namespace gurney::study
