#pragma once

#include <cstddef>
#include <vector>

namespace gurney::statistics {

/// One run seen at one limit: did it exceed at its intensity?
struct Observation {
  double im = 0;  ///< > 0, any unit
  bool exceeded = false;
  std::size_t group = 0;  ///< runs that share a record are not independent: its number
  std::size_t analysis_case =
      0;  ///< of a record: runs that differ in their intensity alone share it
};

/// What happened at one intensity.
struct Stripe {
  double im = 0;
  double runs = 0, exceeded = 0;  ///< counts; double, for they are weights in sums

  double fraction() const { return exceeded / runs; }
};

/// Observations counted by distinct intensity, for all and for each group.
///
/// A resample of groups is then a sum of counts, without a look at single runs.
class StripeTable {
 public:
  /// The order of the observations changes nothing.
  /// @throws Error unless every im is > 0 and finite.
  explicit StripeTable(const std::vector<Observation>& observations);

  const std::vector<Stripe>& stripes() const { return stripes_; }  ///< im increases
  std::size_t groups() const { return of_group_.size(); }          ///< those that have a run

  /// Whether a group has several runs at one intensity: such runs are not independent.
  bool repeats_groups() const;

  struct Share {
    std::size_t stripe;
    double runs, exceeded;
  };
  const std::vector<Share>& of_group(std::size_t group) const { return of_group_[group]; }

  /// Stripes with each group counted `times[group]` times; stripes left without runs stay, empty.
  std::vector<Stripe> resampled(const std::vector<int>& times) const;

 private:
  std::vector<Stripe> stripes_;
  std::vector<std::vector<Share>> of_group_;
};

}  // namespace gurney::statistics
