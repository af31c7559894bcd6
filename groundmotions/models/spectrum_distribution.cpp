#include "groundmotions/models/spectrum_distribution.h"

#include <cmath>

#include "engine/base/random/normal_draw.h"

namespace gurney::groundmotions {
namespace {

Eigen::MatrixXd epsilon_correlations(const Eigen::VectorXd& periods) {
  return Eigen::MatrixXd::NullaryExpr(
      periods.size(), periods.size(),
      [&](Eigen::Index i, Eigen::Index j) { return epsilon_correlation(periods[i], periods[j]); });
}

/// Correlations that remain where the value at `at` is given; 0 with itself.
Eigen::MatrixXd partial_correlations(const Eigen::MatrixXd& rho, Eigen::Index at) {
  const Eigen::VectorXd given = rho.col(at);
  Eigen::VectorXd left = (1 - given.array().square()).max(0).sqrt().inverse();
  left[at] = 0;
  return left.asDiagonal() * (rho - given * given.transpose()) * left.asDiagonal();
}

}  // namespace

Eigen::VectorXd SpectrumDistribution::quantile(double probability) const {
  return (mean + normal_quantile(probability) * sigma()).array().exp();
}

SpectrumDistribution bssa14_spectrum(const Scenario& scenario, const Eigen::VectorXd& periods) {
  Eigen::VectorXd median(periods.size()), sigma(periods.size());
  for (Eigen::Index i = 0; i < periods.size(); ++i) {
    const Prediction p = bssa14_sa(scenario, periods[i]);
    median[i] = p.median;
    sigma[i] = p.sigma();
  }
  return correlated_spectrum(periods, median, sigma);
}

SpectrumDistribution conditioned(const SpectrumDistribution& spectrum, Eigen::Index at,
                                 double ln_sa) {
  const Eigen::VectorXd with = spectrum.covariance.col(at);  // rho_i* sigma_i sigma_*
  const double variance = with[at];
  SpectrumDistribution result = spectrum;
  result.mean += with * ((ln_sa - spectrum.mean[at]) / variance);
  result.covariance -= with * with.transpose() / variance;
  // Exact where rounding would leave some 1e-17, whose square root is not small.
  result.mean[at] = ln_sa;
  result.covariance.row(at).setZero();
  result.covariance.col(at).setZero();
  return result;
}

SpectrumDistribution correlated_spectrum(const Eigen::VectorXd& periods,
                                         const Eigen::VectorXd& median,
                                         const Eigen::VectorXd& sigma,
                                         std::optional<Eigen::Index> conditioning) {
  const Eigen::Index n = periods.size();
  SpectrumDistribution result{periods, median.array().log(), Eigen::MatrixXd::Zero(n, n)};
  if (sigma.isZero(0)) return result;
  Eigen::MatrixXd rho = epsilon_correlations(periods);
  if (conditioning) rho = partial_correlations(rho, *conditioning);
  result.covariance = sigma.asDiagonal() * rho * sigma.asDiagonal();
  // Keeps what was given at T*, too.
  result.covariance.diagonal() = sigma.array().square();
  return result;
}

}  // namespace gurney::groundmotions
