#include "studies/statistics/lognormal.h"

#include <cmath>

#include "engine/base/random/normal_draw.h"

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

}  // namespace gurney::statistics
