#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "studies/statistics/bands.h"
#include "studies/statistics/special.h"

namespace gurney::statistics {

/// Mean annual rate of exceeding an intensity at a site: as points, or as k0 im^-k for every im >
/// 0.
class HazardCurve {
 public:
  /// Between the points ln rate is linear in ln im; outside them nothing is known.
  /// @throws Error unless there are two or more, im > 0 increases and rate > 0 [1/year] decreases.
  static HazardCurve table(std::vector<double> im, std::vector<double> rate);

  /// @throws Error unless k0 > 0 and k > 0.
  static HazardCurve power_law(double k0, double k);

  /// None outside the table: a hazard is not extrapolated.
  std::optional<double> rate(double im) const;

  /// rate = factor im^-exponent from `low` to `high`.
  struct Piece {
    double low, high, log_factor, exponent;
  };
  const std::vector<Piece>& pieces() const { return pieces_; }

 private:
  std::vector<Piece> pieces_;
};

/// Mean annual rate of exceeding a limit, as far as the hazard curve reaches.
struct MeanRate {
  double rate = 0;        ///< what is certain [1/year]: above the table with P at its end
  double most_above = 0;  ///< motions above the table can add this at most
  double below = 0;       ///< P at the table's lowest im: weaker motions add this times their rate

  /// Neither end matters: most_above <= share * rate, and P at the lowest im <= share.
  bool complete(double share = 0.01) const { return most_above <= share * rate && below <= share; }
};

/// Integral of P(exceeded | im) |d rate(im)| (Cornell & Krawinkler 2000, PEER Center News 3(2)).
/// Exact for a lognormal curve: on a piece c im^-k it is P1 r1 - P2 r2 + c theta^-k exp(k^2 beta^2
/// / 2) (Phi(z2 + k beta) - Phi(z1 + k beta)), z = ln(im / theta) / beta; over all im that is
/// Cornell's k0 theta^-k exp(k^2 beta^2 / 2) (Cornell et al. 2002, J. Struct. Eng. 128(4),
/// 526-533).
MeanRate mean_rate(const LognormalCurve& curve, const HazardCurve& hazard);

/// Its part from intensities between `low` and `high`, as far as the hazard curve reaches.
double rate_between(const LognormalCurve& curve, const HazardCurve& hazard, double low,
                    double high);

/// mean_rate() of any curve, by Gauss-Legendre on panels of at most 0.05 in ln im.
/// @param probability  within [0, 1]
/// @throws Error for a power law: its range is unbounded.
MeanRate mean_rate(const std::function<double(double)>& probability, const HazardCurve& hazard);

/// Probability of one event or more in some years of a Poisson process, 1 - exp(-rate years).
double probability_in(double years, double rate);

/// Least and largest mean annual rate of the lines (slope, intercept) around the region of a band
/// (FragilityBand::outline). The rate rises with the intercept everywhere, so its extremes are on
/// the outline. Infinite where a line does not rise and the hazard has no lowest intensity.
/// [0, infinity] without an outline.
Interval rate_interval(const std::vector<Eigen::Vector2d>& outline, const HazardCurve& hazard);

/// P(the level is the worst reached) from P(level or worse) of ordered levels at one im.
struct LevelProbabilities {
  std::vector<double> of_level;  ///< none first, then each level; sums to 1
  bool crossed = false;  ///< a worse level was more likely than a better one and was cut to it
};

/// @param exceedance  P(level or worse), mildest level first
/// @throws Error unless all are within [0, 1].
LevelProbabilities level_probabilities(const std::vector<double>& exceedance);

}  // namespace gurney::statistics
