#include "studies/statistics/lognormal.h"

#include <fmt/format.h>

#include <cmath>

#include "engine/base/error.h"
#include "engine/base/random/normal_draw.h"
#include "studies/statistics/special.h"

namespace gurney::statistics {

double LognormalCurve::probability(double im) const {
  return im > 0 ? normal_cdf(std::log(im / theta) / beta) : 0;
}

double LognormalCurve::quantile(double probability) const {
  return theta * std::exp(beta * normal_quantile(probability));
}

double LognormalCurve::mean() const { return theta * std::exp(beta * beta / 2); }

double LognormalCurve::standard_deviation() const {
  return mean() * std::sqrt(std::expm1(beta * beta));
}

double LognormalCurve::density(double im) const {
  return im > 0 ? normal_density(std::log(im / theta) / beta) / (beta * im) : 0;
}

LognormalCurve lognormal_of_moments(double mean, double standard_deviation) {
  require(mean > 0 && std::isfinite(mean), fmt::format("mean = {:g} must be > 0", mean));
  require(standard_deviation > 0 && std::isfinite(standard_deviation),
          fmt::format("standard deviation = {:g} must be > 0", standard_deviation));
  const double variation = standard_deviation / mean;
  const double beta = std::sqrt(std::log1p(variation * variation));
  return {mean * std::exp(-beta * beta / 2), beta};
}

}  // namespace gurney::statistics
