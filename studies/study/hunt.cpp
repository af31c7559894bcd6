#include "studies/study/hunt.h"

#include <algorithm>

namespace gurney {

std::optional<double> Intensities::next() const {
  if (stopped_) return {};
  if (plan_->kind == IntensityPlan::Kind::kHunt) return hunted();
  if (done_ == plan_->levels.size()) return {};
  return plan_->levels[done_];
}

std::optional<double> Intensities::hunted() const {
  if (done_ == static_cast<std::size_t>(plan_->most_runs)) return {};
  if (done_ == 0) return plan_->first;
  if (!exceeded_) return highest_ + plan_->increment * static_cast<double>(done_);
  const double bracket = *exceeded_ - safe_;
  if (bracket <= plan_->resolution * safe_) return {};
  return safe_ + 0.5 * bracket;
}

void Intensities::report(double value, bool exceeded) {
  ++done_;
  highest_ = std::max(highest_, value);
  if (exceeded)
    exceeded_ = std::min(value, exceeded_.value_or(value));
  else if (!exceeded_ || value < *exceeded_)
    safe_ = std::max(safe_, value);
}

}  // namespace gurney
