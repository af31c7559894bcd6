#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "studies/statistics/fragility.h"

namespace gurney::statistics {

struct Interval {
  double low = 0, high = 0;

  bool contains(double x) const { return low <= x && x <= high; }
};

/// Fewer effective groups determine no interval of an outcome's curve; coverage from 8 on:
/// docs/theory/statistics.md.
inline constexpr double kFewestGroups = 8;

/// An end of theta farther than this factor beyond the intensities of the runs is unbounded: it
/// would rest on the form of the curve alone. The same for an end of beta and beta itself.
inline constexpr double kFarthestEnd = 10;

/// Confidence band of a fragility curve, pointwise.
struct FragilityBand {
  FragilityStatus status = FragilityStatus::kNoRuns;  ///< of the fit to all runs

  /// For each im: the band of the curve. Empty where there is a curve, but too few groups.
  std::vector<Interval> of_curve;

  /// theta: the intensities at which the band holds P = 0.5 (Fieller 1954, J. R. Statist. Soc. B
  /// 16(2), 175-185). An end that the runs do not bound is 0 or infinity; both unless kFitted.
  Interval theta, beta;

  double effective = 0;  ///< groups that count as one each; 0 without a curve
  bool too_few = false;  ///< effective groups for any interval

  /// Lines (slope, intercept) around the region that the band covers: any other number of the curve
  /// lies between its least and its largest on them. 1 - cos(pi / 128) = 3e-4 of a half-width
  /// is between two of them.
  std::vector<Eigen::Vector2d> outline;
};

/// Pointwise band of the curve at the given intensities: z -+ q s of z = slope ln im + intercept,
/// carried over by Phi, with Student's quantile q for effective groups - 1 degrees and s^2 the
/// largest of the variances by line_covariances(). Without a fit the distribution-free band.
/// @throws Error unless im > 0 and confidence in (0, 1)
FragilityBand fragility_band(const StripeTable& table, const std::vector<double>& im,
                             double confidence = 0.95);

/// An estimated line z = slope ln im + intercept of P = Phi(z).
struct LineEstimate {
  Eigen::Vector2d line;                      ///< slope > 0
  std::vector<Eigen::Matrix2d> covariances;  ///< the first with runs independent
  double effective;                          ///< groups
  double lowest, highest;                    ///< im of the runs
};

/// The band of a curve with its intervals, of the kind above.
FragilityBand band_of(const LineEstimate& estimate, const std::vector<double>& im,
                      double confidence);

/// The points of an ellipse around `line`: |L^-1 (point - line)| = quantile, L L' = covariance.
std::vector<Eigen::Vector2d> outline_of(const Eigen::Vector2d& line,
                                        const Eigen::Matrix2d& covariance, double quantile);

/// With ends that are beyond kFarthestEnd of [low, high] made 0 or infinity.
Interval bounded(const Interval& interval, double low, double high);

/// Band that supposes nothing but a probability that does not fall with im: Clopper & Pearson
/// (1934, Biometrika 26(4), 404-413) above from one run of each group at its lowest intensity >=
/// im, below from one of each at its highest <= im. Wide, but true for any number of runs.
std::vector<Interval> distribution_free_band(const StripeTable& table,
                                             const std::vector<double>& im,
                                             double confidence = 0.95);

/// Bounds of the median: it lies above `low`, if that is > 0, and below `high`, if that is finite.
struct MedianBounds {
  double low = 0, high = std::numeric_limits<double>::infinity();

  bool known() const { return low > 0 || std::isfinite(high); }
};

/// Bounds that suppose nothing but a probability that does not fall with im: intensities of runs up
/// to which the distribution-free band is below 1/2 at each, and from which on it is above. Each
/// bound is wrong with a probability of (1 - confidence) / 2 at most, as a sequence of tests in a
/// fixed order that ends with the first that does not reject (Maurer, Hothorn & Lehmacher 1995).
MedianBounds median_bounds(const StripeTable& table, double confidence = 0.95);

/// Clopper-Pearson interval of a probability from `successes` in `trials`.
Interval proportion_interval(int successes, int trials, double confidence = 0.95);

struct ProfileIntervals {
  Interval theta, beta;  ///< an end the data do not bound is 0 or infinity
};

/// Where the likelihood ratio, the other parameter at its best, is below a quantile: that of
/// chi-squared with one degree (Venzon & Moolgavkar 1988, Applied Statistics 37(1), 87-94) for
/// independent runs. With `by_group` the ratio is first divided by the variance for groups over
/// that for independent runs (Chandler & Bate 2007, Biometrika 94(1), 167-183) and compared with
/// Student's quantile squared; the ratio of variances is at least 1, and at least its mean over
/// both parameters. None unless the fit is kFitted (and, by group, there are two groups).
std::optional<ProfileIntervals> profile_intervals(const StripeTable& table,
                                                  double confidence = 0.95, bool by_group = false);

}  // namespace gurney::statistics
