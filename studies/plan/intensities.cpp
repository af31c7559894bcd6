#include "studies/plan/intensities.h"

#include <algorithm>
#include <iterator>

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

}  // namespace gurney::study
