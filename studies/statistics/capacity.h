#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "studies/statistics/bands.h"
#include "studies/statistics/censored_normal.h"
#include "studies/statistics/fragility.h"

namespace gurney::statistics {

/// The bounds that an incremental dynamic analysis sets to the capacity of one analysis case:
/// low < capacity <= high.
struct Capacity {
  std::size_t group = 0;  ///< its record
  double low = 0;         ///< highest im without exceedance below `high`; 0 if there is none
  double high = 0;        ///< lowest im that exceeds: the capacity; infinity if none does
  int resurrections = 0;  ///< runs at or above `high` that do not exceed
  int runs = 0;
  double weight = 1;  ///< one over the analysis cases of its record
  std::size_t analysis_case = 0;
};

/// The capacity of each analysis case by first exceedance (Vamvatsikos & Cornell 2002, EESD 31(3),
/// 491-514), in increasing order of groups and in them of cases. The order of the runs changes
/// nothing.
/// @throws Error unless every im is > 0 and finite.
std::vector<Capacity> ida_capacities(const std::vector<Observation>& observations);

/// Shares of the analysis cases at the ends of their brackets: at each end count those whose bracket
/// says whether they exceed there. Runs are counted as weights.
std::vector<Stripe> stripes_of(const std::vector<Capacity>& capacities);

struct CapacityFit {
  FragilityStatus status = FragilityStatus::kNoRuns;
  std::optional<LognormalCurve> curve;  ///< kFitted only
  double low = 0, high = 0;             ///< separated: all capacities can lie in this interval
  Eigen::Matrix2d covariance{{0, 0}, {0, 0}};  ///< of (ln theta, ln beta)
  double log_likelihood = 0;                   ///< its limit if separated
  int censored = 0;                            ///< records that never exceed
  int resurrections = 0;                       ///< of all records
};

/// Lognormal capacities by maximum likelihood from brackets; records that never exceed count as
/// above their highest im (Baker 2015, where the bracket has no width). A bracket with low == high
/// is an exact capacity. Brackets that share a point are separated: one capacity would explain all,
/// and beta is not determined.
///
/// Angles, draws and replicas of one record are not independent: each record has one term of the ln
/// likelihood, the mean over its cases. Intervals are then those of as many capacities as there are
/// records: right where its cases are alike, and wide where they differ (a composite likelihood;
/// Varin, Reid & Firth 2011, Statistica Sinica 21(1), 5-42).
CapacityFit fit_capacities(const std::vector<Capacity>& capacities);

/// Observations of ln capacity for the likelihood: records without information are excluded.
/// @throws Error for a bracket that is none
std::vector<CensoredValue> log_capacities(const std::vector<Capacity>& capacities);

/// Confidence intervals of a lognormal distribution of capacities.
struct CapacityIntervals {
  Interval theta, beta;            ///< an end the data do not bound is 0 or infinity
  std::vector<Interval> of_curve;  ///< for each im, pointwise; it holds P = 0.5 where theta's does
  std::vector<Eigen::Vector2d> outline;  ///< lines where the ratio is at its limit, as of a band
};

/// Fewer effective capacities determine no interval; coverage: docs/theory/statistics.md.
inline constexpr double kFewestCapacities = 4;

/// Profile likelihood intervals of the fit to brackets (Meeker & Escobar 1995, American
/// Statistician 49(1), 48-53). Their limits of the likelihood ratio are not those of chi-squared,
/// which hold for many records, but those that n exact capacities have: with them theta has
/// Student's interval of mean ln capacity, and beta that of chi-squared, where brackets have no
/// width. n counts censored records by their information on beta (docs/theory/statistics.md).
/// @pre fit.curve, of these capacities
CapacityIntervals capacity_intervals(const std::vector<Capacity>& capacities,
                                     const CapacityFit& fit, const std::vector<double>& im,
                                     double confidence = 0.95);

/// As many exact capacities as these tell of beta: at most the records.
double effective_capacities(const std::vector<Capacity>& capacities, const CapacityFit& fit);

/// Whether capacities are lognormal: p of the largest distance of their empirical distribution from
/// the fitted one, from resamples drawn and bracketed alike (Lilliefors 1967, J. Am. Statist.
/// Assoc. 62, 399-402; Davison & Hinkley 1997, section 4.2.3). Small: they are not. None where a
/// bracket begins at 0.
/// @pre fit.curve, of these capacities
std::optional<double> p_of_lognormal(const std::vector<Capacity>& capacities,
                                     const CapacityFit& fit, int resamples = 499,
                                     std::uint64_t seed = 1);

}  // namespace gurney::statistics
