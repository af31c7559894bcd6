#include "groundmotions/processing/baseline.h"

#include <fmt/format.h>

#include "engine/base/error.h"
#include "engine/base/linear_algebra.h"
#include "groundmotions/measures/peaks.h"

namespace gurney::groundmotions {

namespace {

/// Legendre polynomials of degree 0 to `degree` (columns) at the samples, the record being [-1, 1].
Eigen::MatrixXd legendre(Eigen::Index samples, int degree) {
  const Eigen::ArrayXd x = Eigen::ArrayXd::LinSpaced(samples, -1, 1);
  Eigen::MatrixXd basis(samples, degree + 1);
  basis.col(0).setOnes();
  if (degree > 0) basis.col(1) = x;
  for (int k = 2; k <= degree; ++k)
    basis.col(k) =
        ((2 * k - 1) * x * basis.col(k - 1).array() - (k - 1) * basis.col(k - 2).array()) / k;
  return basis;
}

void check_degree(int degree, int lowest, int highest, Eigen::Index samples) {
  require(degree >= lowest && degree <= highest,
          fmt::format("the degree of the polynomial must be {} to {}, got {}", lowest, highest,
                      degree));
  require(samples >= degree + 2,
          fmt::format("a polynomial of degree {} needs at least {} samples, got {}", degree,
                      degree + 2, samples));
}

}  // namespace

Eigen::VectorXd without_polynomial(const Eigen::VectorXd& acceleration, int degree) {
  check_degree(degree, 0, kHighestBaselineDegree, acceleration.size());
  const Eigen::MatrixXd basis = legendre(acceleration.size(), degree);
  return acceleration - basis * least_squares(basis, acceleration);
}

Eigen::VectorXd without_pre_event_mean(double time_step, const Eigen::VectorXd& acceleration,
                                       double seconds) {
  const double duration = time_step * static_cast<double>(acceleration.size() - 1);
  const double slack = 1e-9 * time_step;
  require(
      seconds >= time_step - slack && seconds <= duration + slack,
      fmt::format("the part before the event must be {:g} to {:g} s long (one step to the whole "
                  "record), got {:g} s",
                  time_step, duration, seconds));
  const auto samples = static_cast<Eigen::Index>((seconds + slack) / time_step) + 1;
  return acceleration.array() - acceleration.head(samples).mean();
}

Eigen::VectorXd ending_at_rest(const Eigen::VectorXd& acceleration, int degree) {
  const Eigen::Index samples = acceleration.size();
  check_degree(degree, 1, kHighestRestDegree, samples);
  // Unit time steps: the scale of time cancels.
  const double duration = static_cast<double>(samples - 1);
  const int terms = degree + 1;
  const Eigen::MatrixXd basis = legendre(samples, degree);
  Eigen::MatrixXd displacement(samples, terms), ends(terms, 2);
  for (int k = 0; k < terms; ++k) {
    const IntegratedMotion motion = integrated(1, basis.col(k));
    displacement.col(k) = motion.displacement / (duration * duration);
    ends.row(k) << motion.velocity[samples - 1] / duration, displacement(samples - 1, k);
  }
  const Eigen::VectorXd target = integrated(1, acceleration).displacement / (duration * duration);
  const EndMotion left = end_motion(1, acceleration);
  const Eigen::Vector2d wanted(left.velocity / duration, target[samples - 1]);

  // ends^T c = wanted: c = Q1 R^-T wanted + Q2 y, with y free for the fit.
  const QrFactors factors = qr_factors(ends);
  const Eigen::MatrixXd& q = factors.q;
  const Eigen::Matrix2d r = factors.r.topRows<2>();
  Eigen::VectorXd c =
      q.leftCols<2>() * r.transpose().triangularView<Eigen::Lower>().solve(wanted).eval();
  if (terms > 2) {
    const Eigen::MatrixXd free = q.rightCols(terms - 2);
    c += free * least_squares(displacement * free, target - displacement * c);
  }
  return acceleration - basis * c;
}

}  // namespace gurney::groundmotions
