#pragma once

/// Distribution functions for tests and intervals; the normal one is in engine/base/random.
namespace gurney::statistics {

double normal_density(double x);

/// ln Phi(x) without underflow, relative error below 1e-9 for every finite x: the asymptotic series
/// where x < -37 (Abramowitz & Stegun 1964, 26.2.12).
double log_normal_cdf(double x);

/// phi(x) / Phi(x), the slope of log_normal_cdf(); about -x far below zero.
double normal_hazard_below(double x);

/// ln(Phi(high) - Phi(low)) for low < high, from the tail that is exact; either may be infinite.
double log_normal_between(double low, double high);

/// P(X > x) of the chi-squared distribution, degrees > 0; 1 for x <= 0.
double chi_squared_survival(double x, double degrees);
double chi_squared_quantile(double probability, double degrees);

/// P(T > t) of Student's distribution, degrees > 0.
double student_survival(double t, double degrees);
double student_quantile(double probability, double degrees);

/// P(F > f) of Fisher's distribution; 1 for f <= 0.
double fisher_survival(double f, double degrees_above, double degrees_below);

/// P(K <= k) of n trials with the given probability of success; 0 for k < 0.
double binomial_cdf(int k, int n, double probability);

/// Quantile of the beta distribution; 0 where a = 0, 1 where b = 0.
double beta_quantile(double probability, double a, double b);

}  // namespace gurney::statistics
