#pragma once

#include <Eigen/Core>
#include <optional>

#include "groundmotions/models/bssa14.h"

namespace gurney::groundmotions {

/// Response spectrum as a random vector: the logarithms of Sa at the periods are jointly normal.
struct SpectrumDistribution {
  Eigen::VectorXd periods;     ///< growing, > 0 [s]
  Eigen::VectorXd mean;        ///< mu, of ln Sa, with Sa in m/s2; exp(mu) is the median
  Eigen::MatrixXd covariance;  ///< of ln Sa, symmetric

  Eigen::VectorXd sigma() const { return covariance.diagonal().cwiseSqrt(); }
  Eigen::VectorXd quantile(double probability) const;  ///< of Sa at each period, in (0, 1) [m/s2]
};

/// Distribution of the spectra of a scenario: mu and sigma of Boore et al. (2014), correlations rho
/// of Baker & Jayaram (2008); C_ij = rho(T_i, T_j) sigma_i sigma_j.
///
/// @param periods  growing, 0.01 to 10 s
/// @throws Error for a scenario or a period out of range.
SpectrumDistribution bssa14_spectrum(const Scenario& scenario, const Eigen::VectorXd& periods);

/// Conditional spectrum: the distribution where Sa(T*) has a given value. With
/// epsilon = (ln Sa(T*) - mu(T*)) / sigma(T*),
///
///     mu_i|*  = mu_i + rho(T_i, T*) sigma_i epsilon
///     C_ij|* = sigma_i sigma_j (rho_ij - rho_i* rho_j*)
///
/// Baker (2011), Conditional mean spectrum: tool for ground-motion selection, J. Struct. Eng.
/// 137(3), 322-331, equation (5) (its square root of 1 - rho^2 is the diagonal of C); covariance:
/// Jayaram, Lin & Baker (2011), Earthquake Spectra 27(3), 797-815. At T* the mean is exactly ln
/// Sa(T*), and sigma exactly 0.
///
/// @param at     index of T* in the periods, where sigma > 0
/// @param ln_sa  ln Sa(T*), Sa in m/s2
SpectrumDistribution conditioned(const SpectrumDistribution& spectrum, Eigen::Index at,
                                 double ln_sa);

/// Distribution with given median and sigma at each period, and correlations of Baker & Jayaram
/// (2008), or where the spectrum is conditional on Sa(T*) those that they leave:
///
///     rho_ij|* = (rho_ij - rho_i* rho_j*) / sqrt((1 - rho_i*^2) (1 - rho_j*^2))
///
/// @param median        > 0 [m/s2]
/// @param sigma         of ln Sa, >= 0
/// @param conditioning  index of T* in the periods
/// @throws Error for a period out of 0.01 to 10 s where sigma is not 0.
SpectrumDistribution correlated_spectrum(const Eigen::VectorXd& periods,
                                         const Eigen::VectorXd& median,
                                         const Eigen::VectorXd& sigma,
                                         std::optional<Eigen::Index> conditioning = {});

}  // namespace gurney::groundmotions
