#include "studies/statistics/special.h"

#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <numbers>

#include "engine/base/random/normal_draw.h"

namespace gurney::statistics {

double normal_density(double x) { return std::exp(-x * x / 2) / std::sqrt(2 * std::numbers::pi); }

double log_normal_cdf(double x) {
  if (std::isinf(x)) return x > 0 ? 0 : x;
  if (x > 0) return std::log1p(-normal_cdf(-x));
  if (x > -37) return std::log(normal_cdf(x));
  const double r = 1 / (x * x);
  return -x * x / 2 - std::log(-x) - std::log(2 * std::numbers::pi) / 2 +
         std::log1p(-r * (1 - 3 * r * (1 - 5 * r)));
}

double normal_hazard_below(double x) {
  if (x > -37) return normal_density(x) / normal_cdf(x);
  return std::exp(-x * x / 2 - std::log(2 * std::numbers::pi) / 2 - log_normal_cdf(x));
}

double log_normal_between(double low, double high) {
  if (low > 0) return log_normal_between(-high, -low);
  const double a = log_normal_cdf(high);
  return std::isinf(low) ? a : a + std::log(-std::expm1(log_normal_cdf(low) - a));
}

double chi_squared_survival(double x, double degrees) {
  if (!(x > 0)) return 1;
  return cdf(complement(boost::math::chi_squared(degrees), x));
}

double chi_squared_quantile(double probability, double degrees) {
  return quantile(boost::math::chi_squared(degrees), probability);
}

double student_survival(double t, double degrees) {
  return cdf(complement(boost::math::students_t(degrees), t));
}

double student_quantile(double probability, double degrees) {
  return quantile(boost::math::students_t(degrees), probability);
}

double fisher_survival(double f, double degrees_above, double degrees_below) {
  if (!(f > 0)) return 1;
  return cdf(complement(boost::math::fisher_f(degrees_above, degrees_below), f));
}

double binomial_cdf(int k, int n, double probability) {
  if (k < 0) return 0;
  if (k >= n) return 1;
  return cdf(boost::math::binomial(n, probability), k);
}

double beta_quantile(double probability, double a, double b) {
  if (a == 0) return 0;
  if (b == 0) return 1;
  return quantile(boost::math::beta_distribution<>(a, b), probability);
}

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
