#pragma once

#include <Eigen/Core>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "studies/statistics/lognormal.h"
#include "studies/statistics/newton.h"
#include "studies/statistics/stripes.h"

namespace gurney::statistics {

/// Why there is a curve or none.
enum class FragilityStatus {
  kFitted,
  kNoRuns,
  kAllExceed,       ///< theta lies somewhere below the lowest im
  kNoneExceeds,     ///< theta lies somewhere above the highest im
  kSeparated,       ///< complete: all above an interval of im exceed, none below
  kQuasiSeparated,  ///< quasi-complete: the same, with both outcomes at one im only
  kNotIncreasing,   ///< no rise of the probability with im: no lognormal curve
};

/// `no run exceeds` and the like, for a reader.
std::string text(FragilityStatus status);

/// What is known of theta where there is no curve: it lies above `low`, if that is > 0, and below
/// `high`, if that is finite; both at one im: about there.
struct MedianBounds {
  double low = 0, high = std::numeric_limits<double>::infinity();

  bool known() const { return low > 0 || std::isfinite(high); }
};

/// Those of a quasi-complete separation at `im`, where `fraction` exceeds: the likelihood is
/// highest for a step there, so theta lies beyond it on the side of the rarer outcome, as far as
/// the next intensity on that side (0 or infinity if there is none).
MedianBounds median_bounds(double im, double fraction, double next_below, double next_above);

/// The maximum of the binomial likelihood of Phi(slope ln im + intercept).
struct ProbitFit {
  FragilityStatus status = FragilityStatus::kNoRuns;
  double low = 0, high = 0;    ///< separated: highest im without, lowest with exceedance
  Eigen::Vector2d line{0, 0};  ///< slope, intercept; kFitted and kNotIncreasing if found
  Eigen::Matrix2d information{{0, 0}, {0, 0}};  ///< observed Fisher information of the line
  double log_likelihood = 0;  ///< without the binomial coefficients; its limit if separated

  double score(double im) const;  ///< slope ln im + intercept
  bool has_line() const { return information(0, 0) > 0; }
  LognormalCurve curve() const;  ///< @pre kFitted
};

/// Multiple stripes by maximum likelihood (Baker 2015, Earthquake Spectra 31(1), 579-599),
/// as a probit regression on ln im by Newton's method with step halving.
///
/// The maximum exists and is unique unless the outcomes are separated (Silvapulle 1981, J. R.
/// Statist. Soc. B 43(3), 310-313), and that is found by comparing intensities, not from a
/// diverging iteration.
ProbitFit fit_probit(const std::vector<Stripe>& stripes);

/// The ln likelihood of a line (slope, intercept) and its derivatives; concave.
Quadratic<2> binomial_likelihood(const std::vector<Stripe>& stripes, const Eigen::Vector2d& line);

/// The same for another likelihood of (slope, intercept) that is concave, such as the logistic one.
ProbitFit fit_line(const std::vector<Stripe>& stripes,
                   const std::function<Quadratic<2>(const Eigen::Vector2d&)>& likelihood);

/// Covariance of the line that allows for dependence within groups (Liang & Zeger 1986, Biometrika
/// 73(1), 13-22): (G - 1) / G sum u_g u_g', u_g = (I - I_g)^-1 s_g with s_g the score and I_g the
/// information of group g. Without I_g it is too small for few groups, whose scores the fit has
/// pulled towards 0: this is the jackknife over groups to first order (Bell & McCaffrey 2002,
/// Survey Methodology 28(2), 169-181).
/// @pre fit.has_line(); two or more groups
Eigen::Matrix2d cluster_covariance(const ProbitFit& fit, const StripeTable& table);

/// Covariances of the line of which an interval takes that with the larger variance: with runs
/// independent, which groups cannot improve on but by chance; with groups independent; and with as
/// much dependence as the second shows over all, r V_1 + (1 - r) I^-1, where V_1 is that of runs
/// which one capacity of their group decides. The second alone is too small in one direction by
/// chance, and then the estimate of it is extreme: it underrates its error most where it is worst.
/// The first alone with one group.
/// @pre fit.has_line()
std::vector<Eigen::Matrix2d> line_covariances(const ProbitFit& fit, const StripeTable& table);

/// As many groups of equal weight as have the same sum of squares of their shares in the expected
/// information: their number where all have the same runs (Carter, Schnepel & Steigerwald 2017,
/// Review of Economics and Statistics 99(4), 698-709, in its simplest form).
/// @pre fit.has_line()
double effective_groups(const ProbitFit& fit, const StripeTable& table);

struct FragilityFit {
  FragilityStatus status = FragilityStatus::kNoRuns;
  std::optional<LognormalCurve> curve;  ///< kFitted only

  /// Separated: theta lies in [low, high]. All exceed: low = 0. None exceeds: high = infinity.
  double low = 0, high = 0;
  MedianBounds median;  ///< without a curve; quasi-separated: not [low, high], which is the one im

  Eigen::Matrix2d covariance;  ///< of (ln theta, ln beta), runs independent; zero unless fitted
  Eigen::Matrix2d cluster_covariance;  ///< the same, groups independent; zero if there is one group
  double effective_groups = 0;         ///< zero unless fitted
  double log_likelihood = 0;           ///< without the binomial coefficients
  std::size_t runs = 0, exceeded = 0, groups = 0;
};

/// @throws Error as StripeTable.
FragilityFit fit_fragility(const std::vector<Observation>& observations);
FragilityFit fit_fragility(const StripeTable& table);

/// Covariance of (ln theta, ln beta) from that of (slope, intercept), by the delta method.
Eigen::Matrix2d covariance_of_curve(const Eigen::Vector2d& line, const Eigen::Matrix2d& covariance);

}  // namespace gurney::statistics
