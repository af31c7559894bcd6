#pragma once

namespace gurney::statistics {

/// A fragility curve P(exceeded | im) = Phi(ln(im / theta) / beta): the lognormal distribution of a
/// capacity (Kennedy et al. 1980, Nuclear Engineering and Design 59(2), 315-338).
struct LognormalCurve {
  double theta = 1;  ///< median capacity, in the unit of im, > 0
  double beta = 1;   ///< standard deviation of ln capacity, > 0

  double probability(double im) const;        ///< 0 for im <= 0
  double quantile(double probability) const;  ///< the im at a probability in (0, 1)
  double mean() const;                        ///< of the capacity, theta exp(beta^2 / 2)
  double standard_deviation() const;          ///< mean sqrt(exp(beta^2) - 1)
};

}  // namespace gurney::statistics
