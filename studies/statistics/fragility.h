#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "studies/statistics/special.h"

namespace gurney::statistics {

/// One run seen at one limit: did it exceed at its intensity?
struct Observation {
  double im = 0;  ///< > 0, any unit
  bool exceeded = false;
  std::size_t group = 0;  ///< runs that share a record are not independent: its number
  std::size_t analysis_case =
      0;  ///< of a record: runs that differ in their intensity alone share it
};

/// Outcomes at one intensity.
struct Stripe {
  double im = 0;
  double runs = 0, exceeded = 0;  ///< counts; double, for they are weights in sums

  double fraction() const { return exceeded / runs; }
};

/// Observations counted by distinct intensity, for all and for each group.
///
/// A resample of groups is then a sum of counts, without a look at single runs.
class StripeTable {
 public:
  /// The order of the observations changes nothing.
  /// @throws Error unless every im is > 0 and finite.
  explicit StripeTable(const std::vector<Observation>& observations);

  const std::vector<Stripe>& stripes() const { return stripes_; }  ///< im increases
  std::size_t groups() const { return of_group_.size(); }          ///< those that have a run

  /// Whether a group has several runs at one intensity: such runs are not independent.
  bool repeats_groups() const;

  struct GroupCounts {
    std::size_t stripe;
    double runs, exceeded;
  };
  const std::vector<GroupCounts>& of_group(std::size_t group) const { return of_group_[group]; }

  /// Stripes with each group counted `times[group]` times; stripes left without runs stay, empty.
  std::vector<Stripe> resampled(const std::vector<int>& times) const;

 private:
  std::vector<Stripe> stripes_;
  std::vector<std::vector<GroupCounts>> of_group_;
};

/// Why there is a curve or none.
enum class FragilityStatus {
  kFitted,
  kNoRuns,
  kAllExceed,
  kNoneExceeds,
  kSeparated,       ///< complete: all above an interval of im exceed, none below
  kQuasiSeparated,  ///< quasi-complete: the same, with both outcomes at one im only
  kNotIncreasing,   ///< no rise of the probability with im: no lognormal curve
};

/// `no run exceeds` and the like, for a reader.
std::string text(FragilityStatus status);

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

  /// Highest im without, lowest with exceedance, if separated. All exceed: low = 0. None exceeds:
  /// high = infinity.
  double low = 0, high = 0;

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

/// Probability under the fitted curve of a deviance at least that of the stripes, the likelihood ratio against a
/// probability of its own for each (McCullagh & Nelder 1989, Generalized linear models, chapter 4): its
/// parametric bootstrap (Davison & Hinkley 1997, section 4.2), p = (1 + number of resamples with at
/// least the deviance) / (1 + resamples), which holds for small counts. It supposes independent runs:
/// where runs of one record are alike p is too small or too large. None unless the fit is kFitted on
/// three stripes or more.
std::optional<double> p_of_fit(const std::vector<Stripe>& stripes, int resamples = 999,
                               std::uint64_t seed = 1);

/// The nondecreasing values nearest to `values` in weighted squares, by pooling adjacent violators
/// (Ayer et al. 1955, Annals of Mathematical Statistics 26(4), 641-647).
/// @throws Error unless there is a weight > 0 for each value.
std::vector<double> isotonic(const std::vector<double>& values, const std::vector<double>& weights);

/// The curve without a form: the most likely probability at each stripe that never falls with im.
/// Stripes without runs are not allowed.
std::vector<double> isotonic_curve(const std::vector<Stripe>& stripes);

}  // namespace gurney::statistics
