#pragma once

#include <Eigen/Cholesky>

/// Decompositions of dense matrices of any size, by Eigen. Each takes the compiler several seconds
/// in every source that instantiates it; here they are compiled once.
namespace gurney {

/// x that minimises |A x - b|, for A of full column rank (Householder QR).
Eigen::VectorXd least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

/// A = Q R, with Q square and orthogonal and R of the shape of A.
struct QrFactors {
  Eigen::MatrixXd q, r;
};
QrFactors qr_factors(const Eigen::MatrixXd& a);

/// The rank of A by Householder QR with column pivoting, and x that minimises |A x - b| where that
/// is the number of columns.
Eigen::Index rank(const Eigen::MatrixXd& a);
Eigen::VectorXd pivoted_least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

/// The shortest x that minimises |A x - b| (complete orthogonal decomposition).
Eigen::VectorXd least_norm_solution(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

/// Eigenvalues of a square matrix by its real Schur form.
Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd& a);

/// K phi = omega^2 M phi with phi' M phi = 1, for symmetric K and positive M; omega^2 ascending.
struct NaturalModes {
  Eigen::VectorXd squared_frequencies;
  Eigen::MatrixXd shapes;  ///< columns
};
NaturalModes natural_modes(const Eigen::MatrixXd& stiffness, const Eigen::MatrixXd& mass);

/// A symmetric matrix as P' L D L' P.
class SymmetricFactors {
 public:
  explicit SymmetricFactors(const Eigen::MatrixXd& a);
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
  void solve_in_place(Eigen::VectorXd& b) const;  ///< without memory of its own
  Eigen::MatrixXd solve(const Eigen::MatrixXd& b) const;
  Eigen::MatrixXd inverse() const;

 private:
  Eigen::LDLT<Eigen::MatrixXd> factors_;
};

}  // namespace gurney
