#pragma once

#include <Eigen/Core>

namespace gurney::groundmotions {

/// Corrections of the zero line of one component; docs/formats/processing.md. Every one is linear in
/// the acceleration.

inline constexpr int kHighestBaselineDegree = 8;
inline constexpr int kHighestRestDegree = 4;

/// Less its least-squares polynomial in time: degree 0 is the mean, 1 a line. The basis is Legendre
/// polynomials on the record made orthogonal at the samples, so all degrees are well conditioned.
/// @param degree  0..8
/// @throws Error for another degree and for fewer than degree + 2 samples.
Eigen::VectorXd without_polynomial(const Eigen::VectorXd& acceleration, int degree);

/// Less the mean of the samples from 0 to `seconds`, the part before the event (Boore 2001, BSSA
/// 91(5), 1199-1211).
/// @param time_step  > 0 [s]
/// @param seconds    > 0, at least one step and at most the duration [s]
Eigen::VectorXd without_pre_event_mean(double time_step, const Eigen::VectorXd& acceleration,
                                       double seconds);

/// Less a polynomial p(t) so that velocity and displacement, the exact integrals of the
/// piecewise-linear acceleration from rest, end at zero to rounding.
///
/// Among all such polynomials of this degree it is the one whose double integral is the least-squares
/// fit to the displacement. With degree 1 the end conditions alone decide: the smallest change of
/// all in the sense of the integral of p^2, and none of a record that ends at rest. With degree 4
/// it is the fit of displacement by a polynomial of order 6 without constant and linear term, its
/// second derivative taken off the acceleration (Ancheta et al. 2013, PEER Report 2013/03), with
/// the two end conditions added; like that one it also takes away true slow displacement. Doing it
/// twice is the same as once. The time step does not matter.
///
/// @param degree  of p, 1..4
/// @throws Error for another degree and for fewer than degree + 2 samples.
Eigen::VectorXd ending_at_rest(const Eigen::VectorXd& acceleration, int degree = 1);

}  // namespace gurney::groundmotions
