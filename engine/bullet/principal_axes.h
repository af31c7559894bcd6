#pragma once

#include <Eigen/Eigenvalues>

#include "engine/base/vector.h"

namespace gurney {

/// Bullet's bodies have diagonal inertias: the axes in which that of a part is diagonal.
struct PrincipalAxes {
  Quaternion rotation;  ///< principal to part axes
  Vector3 moments;      ///< [kg m2]
};

inline PrincipalAxes principal_axes(const Matrix3& inertia) {
  const Eigen::SelfAdjointEigenSolver<Matrix3> solver(inertia);
  Matrix3 axes = solver.eigenvectors();
  if (axes.determinant() < 0) axes.col(0) *= -1;
  return {Quaternion(axes).normalized(), solver.eigenvalues()};
}

}  // namespace gurney
