#pragma once

#include <Eigen/Core>

namespace gurney::groundmotions {

/// How an integral over the samples is taken.
enum class Rule {
  kTrapezoid,  ///< of the integrand at the samples, as records are commonly evaluated
  kExact       ///< of the acceleration taken as linear between the samples
};

/// Arias intensity pi / (2 g) int a^2 dt [m/s] (Arias 1970, in Hansen (ed.), Seismic Design for
/// Nuclear Power Plants, MIT Press, 438-483). The trapezoid is never below the exact integral.
/// @param time_step     > 0 [s]
/// @param acceleration  [m/s2]
double arias_intensity(double time_step, const Eigen::VectorXd& acceleration,
                       Rule rule = Rule::kTrapezoid);

/// Cumulative absolute velocity int |a| dt [m/s] (EPRI 1988, report NP-5930).
double cumulative_absolute_velocity(double time_step, const Eigen::VectorXd& acceleration,
                                    Rule rule = Rule::kTrapezoid);

/// A part of a record between two fractions of its Arias intensity.
struct SignificantPart {
  double begin = 0, end = 0;  ///< from the first sample [s]
  double duration() const { return end - begin; }
};

/// Where the Husid curve, int_0^t a^2 / int a^2 by the trapezoid and linear between the samples,
/// first reaches two fractions (Trifunac & Brady 1975, BSSA 65(3), 581-626: 0.05 and 0.95). All
/// zero for a motion that is all zero.
/// @param from, to  0 <= from <= to <= 1
SignificantPart significant_part(double time_step, const Eigen::VectorXd& acceleration, double from,
                                 double to);

}  // namespace gurney::groundmotions
