#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "studies/statistics/bands.h"

namespace gurney::statistics {

/// How often each of `groups` groups is in bootstrap sample `sample`: as many groups are drawn with
/// replacement. A function of its arguments alone.
std::vector<int> resampled_times(std::size_t groups, std::uint64_t seed, std::uint64_t sample);

/// Percentile interval of a bootstrap over groups (Efron & Tibshirani 1993, An introduction to the
/// bootstrap, chapter 13). It is the same for any number of threads.
/// @param statistic  of a sample, given as how often each group is in it
/// @pre groups > 0; no NaN
Interval bootstrap_interval(std::size_t groups, std::uint64_t seed, int samples, int threads,
                            const std::function<double(const std::vector<int>&)>& statistic,
                            double confidence = 0.95);

/// Outcomes of the runs of one group.
struct GroupOutcomes {
  double runs = 0, happened = 0;
};

/// A probability from runs of which those of a group may be alike.
struct Proportion {
  double estimate = 0;
  Interval interval;
  double effective = 0;  ///< independent runs that would be as telling
};

/// Clopper & Pearson's interval with the effective number of runs n p (1 - p) / variance, the
/// variance that of the ratio of sums over groups (Korn & Graubard 1998, Survey Methodology 24(2),
/// 193-201), within the numbers of groups and of runs. Where all runs agree the groups count.
/// @pre a run
Proportion grouped_proportion(const std::vector<GroupOutcomes>& groups, double confidence = 0.95);

}  // namespace gurney::statistics
