#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "studies/analysis/configuration_view.h"
#include "studies/analysis/fitted_curve.h"
#include "studies/statistics/bands.h"
#include "studies/statistics/fragility.h"

namespace gurney::study {

/// An input that is not the same; empty: it is not there.
struct InputDifference {
  std::string key;  ///< "item.brakes", "study.draws"
  std::string a, b;
};

/// Inputs of two configurations, as far as study files keep them.
struct InputDifferences {
  std::vector<InputDifference> job;          ///< with the levels of their factors put in
  std::vector<InputDifference> assumptions;  ///< numbers without a source, from data files
  std::vector<InputDifference> data_files;   ///< items, casters, rooms, ...: SHA-256
  std::vector<InputDifference> program;
  std::vector<std::string> records_of_a, records_of_b;  ///< of one only
  std::vector<std::string> records_changed;             ///< same name, other files or processing
  std::size_t records_common = 0;

  bool empty() const;
};

InputDifferences input_differences(const ConfigurationView& a, const ConfigurationView& b);

/// Runs of two configurations that had the same record at the same level, and the same angle and
/// draw where both have those in common.
struct RunPairs {
  /// Runs that are held against each other; several of a side count by their mean.
  struct Pair {
    std::vector<std::size_t> a, b;
    std::size_t group = 0;
  };

  /// Units drawn from a population: runs of one group are not independent of each other.
  enum class Group {
    kRecord,
    kDraw,  ///< of the only record in common: what is found holds for that record
    kNone   ///< one record, no draws in common: no chance is left, and no p
  };

  std::vector<Pair> pairs;
  Group group = Group::kRecord;
  std::size_t groups = 0;
  bool by_intensity = false;  ///< else by the factor on the records
  bool by_draw = false, by_angle = false;
  std::string level;                           ///< the study's measure, or "scale"
  std::size_t paired_a = 0, paired_b = 0;      ///< runs
  std::size_t left_out_a = 0, left_out_b = 0;  ///< runs that did not fail but have no partner

  /// Runs of records in common, at whatever level, with their groups.
  std::vector<std::pair<std::size_t, std::size_t>> common_a, common_b;
};

/// Levels are those of the study's intensity measure where both have the same, else factors on the
/// records. Draws are the same numbers where both studies have the same seed, number and sampling
/// of draws; angles are left out of sight where the two have none in common.
/// @throws Error where no run of one has a partner in the other
RunPairs pair_runs(const ConfigurationView& a, const ConfigurationView& b);

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

/// The fragility curves of two configurations. Outcomes and capacities (IDA) are not tested against
/// each other.
struct ComparedCurves {
  std::size_t state = 0;  ///< index in the limit states of A
  std::string name;
  FittedCurve a, b;  ///< of the runs of records in common
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
