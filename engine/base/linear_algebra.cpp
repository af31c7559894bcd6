#include "engine/base/linear_algebra.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <cassert>

namespace gurney {

Eigen::VectorXd least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  return a.householderQr().solve(b);
}

QrFactors qr_factors(const Eigen::MatrixXd& a) {
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(a);
  return {qr.householderQ(), qr.matrixQR().triangularView<Eigen::Upper>()};
}

Eigen::Index rank(const Eigen::MatrixXd& a) {
  return Eigen::ColPivHouseholderQR<Eigen::MatrixXd>(a).rank();
}

Eigen::VectorXd pivoted_least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  return a.colPivHouseholderQr().solve(b);
}

Eigen::VectorXd least_norm_solution(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  return a.completeOrthogonalDecomposition().solve(b);
}

Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd& a) {
  return Eigen::EigenSolver<Eigen::MatrixXd>(a, /*computeEigenvectors=*/false).eigenvalues();
}

NaturalModes natural_modes(const Eigen::MatrixXd& stiffness, const Eigen::MatrixXd& mass) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(stiffness, mass);
  assert(solver.info() == Eigen::Success);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

SymmetricFactors::SymmetricFactors(const Eigen::MatrixXd& a) : factors_(a) {}

Eigen::VectorXd SymmetricFactors::solve(const Eigen::VectorXd& b) const {
  return factors_.solve(b);
}

void SymmetricFactors::solve_in_place(Eigen::VectorXd& b) const { b = factors_.solve(b); }

Eigen::MatrixXd SymmetricFactors::solve(const Eigen::MatrixXd& b) const {
  return factors_.solve(b);
}

Eigen::MatrixXd SymmetricFactors::inverse() const {
  return factors_.solve(Eigen::MatrixXd::Identity(factors_.rows(), factors_.cols()));
}

}  // namespace gurney
