#pragma once

#include <limits>
#include <string>

namespace gurney::config {

/// The numbers a key allows. NaN is never allowed, infinity only where it is stated.
class Range {
 public:
  static Range any() { return {}; }
  static Range more_than(double low) { return {low, kInfinity, true}; }
  static Range at_least(double low) { return {low, kInfinity, false}; }
  static Range within(double low, double high) { return {low, high, false}; }  ///< ends included
  static Range positive() { return more_than(0); }
  static Range not_negative() { return at_least(0); }

  Range open_above() const;     ///< the same without its upper end
  Range open_below() const;     ///< the same without its lower end
  Range with_infinity() const;  ///< the same with +infinity

  bool contains(double value) const;
  bool contains_between(double low, double high) const;  ///< each number low < x < high
  std::string text() const;                              ///< `a finite number > 0`

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  Range() = default;
  Range(double low, double high, bool low_open) : low_(low), high_(high), low_open_(low_open) {}

  double low_ = -kInfinity, high_ = kInfinity;
  bool low_open_ = false, high_open_ = false, infinity_allowed_ = false;
};

}  // namespace gurney::config
