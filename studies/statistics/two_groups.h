#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "studies/statistics/bands.h"
#include "studies/statistics/capacity.h"
#include "studies/statistics/fragility.h"

namespace gurney::statistics {

/// A number seen in a run, or the mean of a record's runs: a demand, or 1 for exceeded and 0 for
/// not.
struct Measured {
  double value = 0;
  std::size_t group = 0;  ///< number of the record: what is paired
};

/// Two groups of outcomes under the same records.
struct PairedDifference {
  int pairs = 0;                  ///< records seen in both
  double mean_a = 0, mean_b = 0;  ///< of the pairs; each the mean of its record's runs
  double difference = 0;          ///< mean_b - mean_a
  /// Interval of the difference by Student's t; all numbers for fewer than two pairs, and where all pairs
  /// differ alike: without scatter it would have no width.
  Interval interval;
  double p_permutation = 1;  ///< two-sided, see paired_difference()
  int rises = 0, falls = 0;  ///< records where b is above, below a
  double p_sign = 1;         ///< two-sided, see sign_test()
};

/// Compares record by record. A record's runs count once, by their mean; records in one group only
/// are left out, and a caller can see how many from `pairs`.
///
/// p_permutation is of the mean difference when each record's difference may as well have the other
/// sign (Fisher 1935, The design of experiments, section 21): all 2^n assignments to 20 records
/// that differ, above that (1 + k) / (1 + 99,999) of drawn ones.
PairedDifference paired_difference(const std::vector<Measured>& a, const std::vector<Measured>& b,
                                   double confidence = 0.95, std::uint64_t seed = 1);

/// Exact sign test, for outcomes that of McNemar (1947, Psychometrika 12(2), 153-157): the
/// probability, under 1/2, of counts as unequal as these. 1 without any.
double sign_test(int rises, int falls);

/// Are two fragilities one?
struct FragilityComparison {
  double likelihood_ratio = 0;          ///< 2 (ln L_a + ln L_b - ln L_common)
  std::optional<double> p_permutation;  ///< from swapped records; none without a pair
  int pairs = 0;                        ///< records in both
};

/// Likelihood-ratio test of two curves against a common one. Separated data have the limit of their
/// likelihood. With records in both groups p_permutation swaps each record's runs between the
/// groups (1 + k) / (1 + resamples), which keeps what the runs of a record have in common.
FragilityComparison compare_fragilities(const std::vector<Observation>& a,
                                        const std::vector<Observation>& b, int resamples = 999,
                                        std::uint64_t seed = 1);

/// The same of capacities by their brackets: a record's are swapped.
FragilityComparison compare_capacities(const std::vector<Capacity>& a,
                                       const std::vector<Capacity>& b, int resamples = 999,
                                       std::uint64_t seed = 1);

/// p-values adjusted for being several, in their order (Holm 1979, Scand. J. Statistics 6(2),
/// 65-70). NaN stays NaN and does not count.
std::vector<double> holm_adjusted(const std::vector<double>& p_values);

}  // namespace gurney::statistics
