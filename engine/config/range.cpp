#include "engine/config/range.h"

#include <fmt/format.h>

#include <cmath>

namespace gurney::config {

Range Range::open_above() const {
  Range range = *this;
  range.high_open_ = true;
  return range;
}

Range Range::open_below() const {
  Range range = *this;
  range.low_open_ = true;
  return range;
}

Range Range::with_infinity() const {
  Range range = *this;
  range.infinity_allowed_ = true;
  return range;
}

bool Range::contains(double value) const {
  if (!std::isfinite(value)) return infinity_allowed_ && value == kInfinity;
  return (low_open_ ? value > low_ : value >= low_) &&
         (high_open_ ? value < high_ : value <= high_);
}

bool Range::contains_between(double low, double high) const { return low_ <= low && high <= high_; }

std::string Range::text() const {
  std::string text = infinity_allowed_ ? "a number" : "a finite number";
  if (low_ > -kInfinity) text += fmt::format(" {} {}", low_open_ ? ">" : ">=", low_);
  if (high_ < kInfinity)
    text +=
        fmt::format("{} {} {}", low_ > -kInfinity ? " and" : "", high_open_ ? "<" : "<=", high_);
  return text + (infinity_allowed_ ? " or inf" : "");
}

}  // namespace gurney::config
