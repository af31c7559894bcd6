#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "studies/analysis/curve_audit.h"
#include "studies/analysis/run_pairs.h"
#include "studies/statistics/bands.h"
#include "studies/statistics/fragility.h"

namespace gurney::study {

/// One quantity of two configurations, by the groups of their pairs.
struct ComparedQuantity {
  enum class Kind {
    kShare,  ///< of runs that exceed a limit state
    kMean,   ///< of a demand
    kMedian  ///< of a demand; `difference` is the median of the groups' differences
  };
  Kind kind = Kind::kShare;
  std::string name, units;
  std::string words;  ///< the definition of a limit state
  std::size_t groups = 0;
  double a = 0, b = 0;
  double difference = 0;          ///< b - a
  statistics::Interval interval;  ///< of the difference
  double p = 1;  ///< see compare_studies(); NaN: no pair differs, or nothing is random
  double p_holm = 1;
};

/// The fragility curves of two configurations.
struct ComparedCurves {
  std::size_t state = 0;  ///< index in the limit states of A
  std::string name;
  statistics::FragilityFit a, b;
  std::vector<statistics::Observation> of_a, of_b;
  CurveAudit audit_a, audit_b;
  double likelihood_ratio = 0;
  double p = 1;  ///< from swapped groups; NaN as above
  double p_holm = 1;
};

/// Rows with a p of each family of tests: the statistics that a reader looks at together.
struct FamilyTests {
  std::size_t shares = 0, curves = 0, means = 0, medians = 0;

  std::size_t all() const { return shares + curves + means + medians; }
  std::size_t largest() const { return std::max({shares, curves, means, medians}); }
};

struct StudyComparison {
  RunPairs pairs;
  std::vector<ComparedQuantity> quantities;
  std::vector<ComparedCurves> curves;
  std::string measure, units;           ///< of the curves; empty: they have none in common
  std::vector<std::string> not_common;  ///< limit states and demands of one side only
  std::size_t overturned = 0;           ///< runs, paired, whose demands end with their fall
  FamilyTests tests;                    ///< that Holm's method counts
  double smallest_p = 0;                ///< that any test can give with so few groups
};

struct ComparisonOptions {
  std::vector<std::string> demands = {};  ///< names; empty: demands_of()
  std::string measure = {};               ///< of the curves; empty: the first that both have
  double confidence = 0.95;
  int resamples = 999;  ///< for the curves
  std::uint64_t seed = 1;
};

/// Every limit state and demand that both have. A group counts once, by the mean of its pairs.
///
/// Means and shares: Student's interval, p of the sign-flip permutation test, which is McNemar's
/// for shares with one pair in each group. Medians: interval from order statistics, p of the sign
/// test. Curves: likelihood ratio of two against one, p by swapping groups. p are adjusted by Holm
/// within each family: shares, curves, means, medians (why: docs/compare.md). A quantity that is
/// equal in all pairs cannot be significant whatever the level, so it is no test.
/// @throws Error as pair_runs()
StudyComparison compare_studies(const ConfigurationView& a, const ConfigurationView& b,
                                const ComparisonOptions& options = {});

}  // namespace gurney::study
