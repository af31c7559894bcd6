#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "studies/statistics/bands.h"
#include "studies/statistics/censored_normal.h"
#include "studies/statistics/fragility.h"

namespace gurney::statistics {

/// One run of a cloud.
struct CloudPoint {
  double im = 0;   ///< > 0
  double edp = 0;  ///< > 0: the demand, or the bound of it
  enum class Known {
    kExactly,
    kAtLeast,  ///< overturned: it exceeds every limit up to `edp`, who knows by how much
    kAtMost,   ///< did not move: below the floor `edp`
  } known = Known::kExactly;
  std::size_t group = 0;  ///< number of the record
};

/// Knowledge of ln EDP of one run.
CensoredValue log_demand(const CloudPoint& point);

enum class CloudStatus {
  kFitted,
  kTooFewExact,   ///< fewer than 3 demands are known exactly
  kOneIntensity,  ///< all exact demands are at one im: no slope
  kNoSpread,      ///< the demands lie on a line exactly: sigma is not determined
};

std::string text(CloudStatus status);

/// ln EDP = a + b ln IM + sigma z.
struct CloudFit {
  CloudStatus status = CloudStatus::kTooFewExact;
  double a = 0, b = 0;
  double sigma = 0;            ///< with n - 2 degrees
  Eigen::Matrix3d covariance;  ///< of (a, b, ln sigma), runs independent; zero unless fitted
  Eigen::Matrix3d cluster_covariance;  ///< the same, groups independent
  double r_squared = 0;                ///< 1 - (sigma / sigma without IM)^2, both by likelihood
  double log_likelihood = 0;
  int exact = 0, at_least = 0, at_most = 0;
};

/// Cloud analysis (Cornell, Jalayer, Hamburger & Foutch 2002, J. Struct. Eng. 128(4), 526-533;
/// Jalayer et al. 2015, Bull. Earthq. Eng. 13(4), 1183-1203) by censored maximum likelihood (Tobin
/// 1958). It is least squares where all demands are exact: sigma is the likelihood's times sqrt(n /
/// (n - 2)).
/// @throws Error unless every im and edp is > 0 and finite.
CloudFit fit_cloud(const std::vector<CloudPoint>& points);

/// The fragility of EDP > limit that follows: theta = exp((ln limit - a) / b), beta = sigma / b.
struct CloudFragility {
  LognormalCurve curve;
  Eigen::Matrix2d covariance;  ///< of (ln theta, ln beta) by the delta method, groups independent
};

/// None unless the cloud is kFitted with b > 0.
/// @throws Error unless limit > 0.
std::optional<CloudFragility> cloud_fragility(const CloudFit& fit, double limit);

/// As many groups with equal numbers of runs as have the same sum of squares of their shares.
double effective_groups(const std::vector<CloudPoint>& points);

/// Its band: that of a line (bands.h) whose covariances are those of the cloud.
/// @param points  those of the fit
/// @pre cloud_fragility(fit, limit)
FragilityBand cloud_band(const CloudFit& fit, const std::vector<CloudPoint>& points, double limit,
                         const std::vector<double>& im, double confidence = 0.95);

}  // namespace gurney::statistics
