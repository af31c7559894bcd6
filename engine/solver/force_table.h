#pragma once

#include <vector>

namespace gurney {

/// A force over time, linear between its points and zero outside. Looking up takes a time that grows
/// with the logarithm of the number of points, as measured pulls have thousands.
class ForceTable {
 public:
  /// `time` [s] increasing, `force` [N] at `time`.
  ForceTable(std::vector<double> time, std::vector<double> force);

  double value(double time) const;
  /// From the first time to `time` [N s]; 0 before it.
  double integral(double time) const;

  const std::vector<double>& times() const { return time_; }

 private:
  /// Value of the line to point i >= 1 from the one before it.
  double on_line(std::size_t i, double time) const;
  double integral_on_line(std::size_t i, double end) const;
  /// The first point that is not before `time`.
  std::size_t point_at(double time) const;

  std::vector<double> time_, force_;
  std::vector<double> integral_;  ///< from the first point to each
};

}  // namespace gurney
