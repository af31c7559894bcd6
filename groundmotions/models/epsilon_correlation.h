#pragma once

namespace gurney::groundmotions {

/// Correlation of epsilon, the normalised residual of a ground-motion model, at two periods: Baker &
/// Jayaram (2008), Correlation of spectral acceleration values from NGA ground motion models,
/// Earthquake Spectra 24(1), 299-317, equations (2)-(5). It is a fit to residuals of models of 2008.
///
/// @param a, b  0.01 to 10 s
/// @throws Error for a period out of range.
double epsilon_correlation(double a, double b);

/// That of PGV and Sa(T): Bradley (2012), Empirical correlations between peak ground velocity and
/// spectrum-based intensity measures, Earthquake Spectra 28(1), 17-35, the equation for Sa:
///
///     rho = (a + b) / 2 - (a - b) / 2 tanh(d ln(T / c)),   a, b, c, d by ranges of T
///
/// @param period  0.01 to 10 s
/// @throws Error for a period out of range.
double pgv_correlation(double period);

}  // namespace gurney::groundmotions
