#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "studies/statistics/bands.h"
#include "studies/statistics/capacity.h"

namespace gurney::statistics {

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
