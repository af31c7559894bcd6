#pragma once

#include <Eigen/Core>
#include <vector>

namespace gurney::calibration {

/// Samples [begin, end).
struct Span {
  std::size_t begin = 0, end = 0;
  std::size_t size() const { return end > begin ? end - begin : 0; }
};

/// The first sample at or after a time.
std::size_t index_at(const std::vector<double>& time, double t);

/// NaN of an empty span.
double mean_of(const std::vector<double>& series, const Span& span);

/// y = sum c_k (t - middle)^k by least squares.
///
/// A motion sampled n times over T seconds with noise of standard deviation s has the acceleration
/// 2 c_2 of a quadratic with the standard error s sqrt(720 / n) / T^2 (n large): 0.1 mm over 2 s at
/// 120 Hz is 4e-5 m/s2, where differences of the samples have s sqrt(6) / dt^2 = 3.5 m/s2.
struct PolynomialFit {
  double middle = 0;           ///< of the samples' times [s]
  Eigen::VectorXd c;           ///< coefficients, c[k] of degree k
  Eigen::MatrixXd covariance;  ///< of c, from the residuals' variance with n - size(c) degrees
  double residual = 0;         ///< standard deviation of the residuals

  double value(double time) const;
  double rate(double time) const;
  double acceleration() const { return 2 * c[2]; }  ///< at the middle
  double acceleration_error() const;
  double rate_error(double time) const;  ///< standard error of rate()
};

/// @pre span.size() > degree + 1
PolynomialFit fit_polynomial(const std::vector<double>& time, const std::vector<double>& y,
                             const Span& span, int degree);

}  // namespace gurney::calibration
