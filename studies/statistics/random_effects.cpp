#include "studies/statistics/random_effects.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "engine/base/error.h"
#include "engine/base/linear_algebra.h"
#include "studies/statistics/special.h"

namespace gurney::statistics {
namespace {

struct Weighted {
  Eigen::VectorXd coefficients;
  Eigen::MatrixXd inverse;  // of X' W X
  double squares;           // weighted, of the residuals
};

Weighted solve(const Eigen::VectorXd& y, const Eigen::VectorXd& variance,
               const Eigen::MatrixXd& design) {
  const Eigen::VectorXd weight = variance.cwiseInverse();
  const Eigen::MatrixXd normal = design.transpose() * weight.asDiagonal() * design;
  const SymmetricFactors factors(normal);
  Weighted result;
  result.coefficients = factors.solve(Eigen::VectorXd(design.transpose() * weight.cwiseProduct(y)));
  result.inverse = factors.inverse();
  const Eigen::VectorXd residual = y - design * result.coefficients;
  result.squares = residual.dot(weight.cwiseProduct(residual));
  return result;
}

/// Scatter^2, where the falling function `squares` of it is n - p.
double paule_mandel(const Eigen::VectorXd& y, const Eigen::VectorXd& measured,
                    const Eigen::MatrixXd& design, double degrees) {
  const auto excess = [&](double scatter) {
    return solve(y, measured.array() + scatter, design).squares - degrees;
  };
  const double plain = solve(y, Eigen::VectorXd::Ones(y.size()), design).squares / degrees;
  const double least = 1e-12 * plain + 1e-300;  // keeps the weights of exact units finite
  if (!(excess(least) > 0)) return least;
  double low = least, high = std::max(2 * plain, least);
  while (excess(high) > 0) high *= 2;
  for (int i = 0; i < 200 && high - low > 1e-14 * high; ++i) {
    const double middle = (low + high) / 2;
    (excess(middle) > 0 ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace

double RandomEffects::error(Eigen::Index i) const { return std::sqrt(covariance(i, i)); }

Interval RandomEffects::interval(Eigen::Index i, double confidence) const {
  const double half = student_quantile((1 + confidence) / 2, degrees) * error(i);
  return {coefficients[i] - half, coefficients[i] + half};
}

double RandomEffects::p_value(Eigen::Index i, double supposed) const {
  const double distance = std::abs(coefficients[i] - supposed);
  if (distance == 0) return 1;
  return 2 * student_survival(distance / error(i), degrees);
}

std::optional<RandomEffects> fit_random_effects(const Eigen::VectorXd& y,
                                                const Eigen::VectorXd& error,
                                                const Eigen::MatrixXd& design) {
  require(error.allFinite() && (error.array() >= 0).all(), "errors of measurement must be >= 0");
  const Eigen::Index n = design.rows(), p = design.cols();
  if (n <= p || design.colPivHouseholderQr().rank() < p) return {};
  RandomEffects fit;
  fit.degrees = static_cast<int>(n - p);
  const Eigen::VectorXd measured = error.cwiseAbs2();
  const double scatter = paule_mandel(y, measured, design, fit.degrees);
  const Weighted found = solve(y, measured.array() + scatter, design);
  fit.scatter = std::sqrt(scatter);
  fit.coefficients = found.coefficients;
  fit.covariance = std::max(1.0, found.squares / fit.degrees) * found.inverse;
  return fit;
}

std::vector<double> outlier_p_values(const Eigen::VectorXd& y, const Eigen::VectorXd& error,
                                     const Eigen::MatrixXd& design) {
  const Eigen::Index n = y.size();
  std::vector<double> result;
  for (Eigen::Index i = 0; i < n; ++i) {
    Eigen::VectorXd others(n - 1), other_error(n - 1);
    Eigen::MatrixXd other_design(n - 1, design.cols());
    for (Eigen::Index k = 0, at = 0; k < n; ++k) {
      if (k == i) continue;
      others[at] = y[k];
      other_error[at] = error[k];
      other_design.row(at++) = design.row(k);
    }
    const auto fit = fit_random_effects(others, other_error, other_design);
    if (!fit) {
      result.push_back(1);
      continue;
    }
    const Eigen::RowVectorXd row = design.row(i);
    const double variance = fit->scatter * fit->scatter + error[i] * error[i] +
                            (row * fit->covariance * row.transpose())(0, 0);
    const double t = std::abs(y[i] - row.dot(fit->coefficients)) / std::sqrt(variance);
    result.push_back(std::min(1.0, 2 * student_survival(t, fit->degrees) * static_cast<double>(n)));
  }
  return result;
}

}  // namespace gurney::statistics
