#pragma once

#include <cmath>

namespace gurney::groundmotions {

enum class Faulting { kUnspecified, kStrikeSlip, kNormal, kReverse };

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

}  // namespace gurney::groundmotions
