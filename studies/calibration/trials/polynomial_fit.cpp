#include "studies/calibration/trials/polynomial_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "engine/base/linear_algebra.h"

namespace gurney::calibration {

std::size_t index_at(const std::vector<double>& time, double t) {
  return static_cast<std::size_t>(std::ranges::lower_bound(time, t) - time.begin());
}

double mean_of(const std::vector<double>& series, const Span& span) {
  double sum = 0;
  for (std::size_t i = span.begin; i < span.end; ++i) sum += series[i];
  return sum / static_cast<double>(span.size());
}

double PolynomialFit::value(double time) const {
  double sum = 0;
  for (Eigen::Index k = c.size(); k-- > 0;) sum = sum * (time - middle) + c[k];
  return sum;
}

double PolynomialFit::rate(double time) const {
  double sum = 0;
  for (Eigen::Index k = c.size(); k-- > 1;)
    sum = sum * (time - middle) + static_cast<double>(k) * c[k];
  return sum;
}

double PolynomialFit::acceleration_error() const { return 2 * std::sqrt(covariance(2, 2)); }

double PolynomialFit::rate_error(double time) const {
  Eigen::VectorXd slope = Eigen::VectorXd::Zero(c.size());
  for (Eigen::Index k = 1; k < c.size(); ++k)
    slope[k] = static_cast<double>(k) * std::pow(time - middle, static_cast<double>(k - 1));
  return std::sqrt(slope.dot(covariance * slope));
}

PolynomialFit fit_polynomial(const std::vector<double>& time, const std::vector<double>& y,
                             const Span& span, int degree) {
  const auto n = static_cast<Eigen::Index>(span.size());
  PolynomialFit fit;
  fit.middle = (time[span.begin] + time[span.end - 1]) / 2;
  const double half = std::max((time[span.end - 1] - time[span.begin]) / 2, 1e-12);
  Eigen::MatrixXd powers(n, degree + 1);  // of times scaled to -1..1
  Eigen::VectorXd values(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const std::size_t at = span.begin + static_cast<std::size_t>(i);
    values[i] = y[at];
    double power = 1;
    for (int k = 0; k <= degree; ++k, power *= (time[at] - fit.middle) / half) powers(i, k) = power;
  }
  const Eigen::VectorXd scaled = least_squares(powers, values);
  const double sum = (values - powers * scaled).squaredNorm();
  fit.residual = std::sqrt(sum / static_cast<double>(n - degree - 1));
  const Eigen::MatrixXd inverse = SymmetricFactors(powers.transpose() * powers).inverse();
  Eigen::VectorXd scale(degree + 1);
  for (int k = 0; k <= degree; ++k) scale[k] = std::pow(half, -k);
  fit.c = scale.cwiseProduct(scaled);
  fit.covariance = fit.residual * fit.residual * scale.asDiagonal() * inverse * scale.asDiagonal();
  return fit;
}

}  // namespace gurney::calibration
