#pragma once

#include <cmath>
#include <string>
#include <vector>

namespace gurney::groundmotions {

enum class Faulting { kUnspecified, kStrikeSlip, kNormal, kReverse };
const std::vector<std::string>& faulting_names();  ///< in this order

/// An earthquake as seen from a site.
struct Scenario {
  double magnitude = 0;  ///< moment magnitude, 3 to 8.5
  double distance = 0;   ///< R_JB, to the surface projection of the rupture, 0 to 400 [km]
  double vs30 = 760;     ///< shear wave velocity of the upper 30 m, 150 to 1500 [m/s]
  Faulting faulting = Faulting::kUnspecified;
};

/// A lognormal prediction.
struct Prediction {
  double median = 0;  ///< RotD50
  double tau = 0;     ///< standard deviation of ln between earthquakes
  double phi = 0;     ///< and within one
  double sigma() const { return std::sqrt(tau * tau + phi * phi); }
};

/// Boore, Stewart, Seyhan & Atkinson (2014), NGA-West2 equations for predicting PGA, PGV, and 5 %
/// damped PSA for shallow crustal earthquakes, Earthquake Spectra 30(3), 1057-1085:
///
///     ln Y = F_E(M, mechanism) + F_P(R_JB, M) + F_S(V_S30, PGA_r)
///
/// for the regions whose anelastic term has no correction (California, New Zealand, Taiwan) and a
/// basin as deep as is the average of its V_S30 (no basin term). bssa14.csv has the coefficients.
///
/// @param period  0: PGA; 0.01 to 10 s, between those of bssa14.csv ln median, tau and phi are
///                straight in ln T
/// @returns       pseudo-acceleration [m/s2]
/// @throws Error for a scenario or a period out of range.
Prediction bssa14_sa(const Scenario& scenario, double period);

/// Peak ground velocity [m/s].
Prediction bssa14_pgv(const Scenario& scenario);

/// Correlation of epsilon, the normalised residual of a ground-motion model, at two periods: Baker &
/// Jayaram (2008), Correlation of spectral acceleration values from NGA ground motion models,
/// Earthquake Spectra 24(1), 299-317, equations (2)-(5). It is a fit to residuals of models of 2008.
///
/// @param a, b  0.01 to 10 s
/// @throws Error for a period out of range.
double epsilon_correlation(double a, double b);

/// Correlation of PGV and Sa(T): Bradley (2012), Empirical correlations between peak ground velocity and
/// spectrum-based intensity measures, Earthquake Spectra 28(1), 17-35, the equation for Sa:
///
///     rho = (a + b) / 2 - (a - b) / 2 tanh(d ln(T / c)),   a, b, c, d by ranges of T
///
/// @param period  0.01 to 10 s
/// @throws Error for a period out of range.
double pgv_correlation(double period);

}  // namespace gurney::groundmotions
