#include "studies/plan/stages.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "studies/statistics/fragility.h"

namespace gurney::study {

std::optional<double> Intensities::next() const {
  if (stopped_) return {};
  if (plan_->kind == IntensityPlan::Kind::kIda) return traced();
  if (done_ == plan_->levels.size()) return {};
  return plan_->levels[done_];
}

std::optional<double> Intensities::traced() const {
  if (done_ == static_cast<std::size_t>(plan_->most_runs)) return {};
  if (done_ == 0) return plan_->first;
  if (!exceeded_) return *tried_.rbegin() + plan_->increment * static_cast<double>(done_);
  if (!narrow_) return 0.5 * (safe_ + *exceeded_);
  if (filled_ == plan_->fill) return {};
  return middle_of_widest_gap();
}

double Intensities::middle_of_widest_gap() const {
  double low = 0, widest = 0, middle = 0;
  for (const double value : tried_) {
    if (value > *exceeded_) break;
    if (value - low > widest) {
      widest = value - low;
      middle = low + 0.5 * widest;
    }
    low = value;
  }
  return middle;
}

void Intensities::report(double value, bool exceeded) {
  ++done_;
  if (narrow_) ++filled_;
  tried_.insert(value);
  if (exceeded)
    exceeded_ = std::min(value, exceeded_.value_or(value));
  else if (!exceeded_ || value < *exceeded_)
    safe_ = std::max(safe_, value);
  // A fill may exceed below what was safe: then the bracket lies lower.
  if (exceeded_ && safe_ > *exceeded_) safe_ = highest_below(*exceeded_);
  narrow_ = narrow_ || (exceeded_ && *exceeded_ - safe_ <= plan_->resolution * safe_);
}

double Intensities::highest_below(double value) const {
  const auto above = tried_.lower_bound(value);
  return above == tried_.begin() ? 0 : *std::prev(above);
}

namespace {

constexpr double kOptimalScore = 1.138;  // +- of the score, at which P is 12.8 and 87.2 %
constexpr double kFarthest = 2, kNear = 1.5, kSame = 0.01, kOutward = 1.05;

using Pair = std::pair<double, double>;

Pair around(double im, const std::vector<statistics::Stripe>& stripes) {
  Pair levels{im / kNear, im * kNear};
  for (const statistics::Stripe& stripe : stripes) {
    if (stripe.im < im) levels.first = std::sqrt(stripe.im * im);
    if (stripe.im > im) {
      levels.second = std::sqrt(stripe.im * im);
      break;
    }
  }
  return levels;
}

Pair wanted(const std::vector<statistics::Stripe>& stripes) {
  const double lowest = stripes.front().im, highest = stripes.back().im;
  const statistics::ProbitFit fit = statistics::fit_probit(stripes);
  switch (fit.status) {
    case statistics::FragilityStatus::kFitted: {
      const statistics::LognormalCurve curve = fit.curve();
      const double least = lowest / kFarthest, most = highest * kFarthest;
      return {std::clamp(curve.theta * std::exp(-kOptimalScore * curve.beta), least, most),
              std::clamp(curve.theta * std::exp(kOptimalScore * curve.beta), least, most)};
    }
    case statistics::FragilityStatus::kAllExceed:
      return {lowest / kFarthest, lowest / kNear};
    case statistics::FragilityStatus::kNoneExceeds:
      return {highest * kNear, highest * kFarthest};
    case statistics::FragilityStatus::kSeparated:
      return {std::cbrt(fit.low * fit.low * fit.high), std::cbrt(fit.low * fit.high * fit.high)};
    case statistics::FragilityStatus::kQuasiSeparated:
      return around(fit.low, stripes);
    case statistics::FragilityStatus::kNoRuns:
    case statistics::FragilityStatus::kNotIncreasing:
      break;
  }
  return {lowest / kNear, highest * kNear};
}

double three_digits(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)) - 2);
  return std::round(value / power) * power;
}

/// @param outward  a factor above 1, or below
double apart_from(const std::vector<double>& made, double level, double outward) {
  const auto same = [&](double im) { return std::abs(level - im) < kSame * im; };
  while (std::ranges::any_of(made, same)) level = three_digits(level * outward);
  return level;
}

}  // namespace

std::vector<double> next_levels(const std::vector<statistics::Stripe>& stripes, double unit) {
  std::vector<double> made;
  for (const statistics::Stripe& stripe : stripes) made.push_back(stripe.im / unit);
  const auto [low, high] = wanted(stripes);
  std::vector<double> levels;
  levels.push_back(apart_from(made, three_digits(low / unit), 1 / kOutward));
  made.push_back(levels.front());
  levels.push_back(apart_from(made, three_digits(high / unit), kOutward));
  for (double& level : levels) level *= unit;
  std::ranges::sort(levels);
  return levels;
}

}  // namespace gurney::study
