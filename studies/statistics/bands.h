#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "studies/statistics/fragility.h"

namespace gurney::statistics {

struct Interval {
  double low = 0, high = 0;

  bool contains(double x) const { return low <= x && x <= high; }
};

struct BandOptions {
  double confidence = 0.95;  ///< of each point for itself, in (0, 1)
  int resamples = 999;       ///< of groups; >= 1
  std::uint64_t seed = 1;
};

/// What a fragility curve may be, pointwise, from resampled groups.
struct FragilityBand {
  FragilityStatus status = FragilityStatus::kNoRuns;  ///< of the fit to all runs

  /// For each im: the band of the curve. See fragility_band() for how it is made.
  std::vector<Interval> of_curve;

  /// theta: the intensities at which the band holds P = 0.5 (Fieller 1954, J. R. Statist. Soc. B
  /// 16(2), 175-185), so an end is 0 or infinity where the slope could be 0. beta: of ln beta, in
  /// the manner of the band. [0, infinity] unless kFitted.
  Interval theta, beta;

  /// For comparison, plain percentiles of the resamples: too narrow for few groups.
  std::vector<Interval> percentile_of_curve;
  Interval percentile_theta, percentile_beta;

  /// The curves of the resamples that are kFitted, in order of resampling.
  std::vector<LognormalCurve> curves;
  int separated = 0;  ///< resamples that are separated or quasi-separated
  int one_sided = 0;  ///< resamples where all exceed or none
  int not_increasing = 0;
};

/// Pointwise band of the curve at the given intensities.
///
/// The band is made for z = slope ln im + intercept, with the covariance for groups, and carried
/// over by Phi: z -+ q s. On each side q is the wider of Student's quantile with groups - 1 degrees
/// and the quantile of bootstrap-t over groups (Efron & Tibshirani 1993, An introduction to the
/// bootstrap, section 12.5). Why, and what it covers: docs/theory/statistics.md. With less than 90
/// % of the resamples fitted, Student's alone. Without a fit, or with one group, the
/// distribution-free band.
/// @throws Error unless the options are in range.
FragilityBand fragility_band(const StripeTable& table, const std::vector<double>& im,
                             const BandOptions& options = {});

/// Band that supposes nothing but a probability that does not fall with im: Clopper & Pearson
/// (1934, Biometrika 26(4), 404-413) above from one run of each group at its lowest intensity >=
/// im, below from one of each at its highest <= im. Wide, but true for any number of runs.
std::vector<Interval> distribution_free_band(const StripeTable& table,
                                             const std::vector<double>& im,
                                             double confidence = 0.95);

/// Clopper-Pearson interval of a probability from `successes` in `trials`.
Interval proportion_interval(int successes, int trials, double confidence = 0.95);

struct ProfileIntervals {
  Interval theta, beta;  ///< an end the data do not bound is 0 or infinity
};

/// Where the likelihood ratio, the other parameter at its best, is below a quantile: that of
/// chi-squared with one degree (Venzon & Moolgavkar 1988, Applied Statistics 37(1), 87-94) for
/// independent runs. With `by_group` the ratio is first divided by the variance for groups over
/// that for independent runs (Chandler & Bate 2007, Biometrika 94(1), 167-183) and compared with
/// Student's quantile squared. None unless the fit is kFitted (and, by group, there are two
/// groups).
std::optional<ProfileIntervals> profile_intervals(const StripeTable& table,
                                                  double confidence = 0.95, bool by_group = false);

}  // namespace gurney::statistics
