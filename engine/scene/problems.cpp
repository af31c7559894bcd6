#include "engine/scene/problems.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <cmath>

namespace gurney {

void Problems::check(bool holds, const std::string& line) {
  if (!holds) add(line);
}

void Problems::check(bool holds, const std::string& name, double value,
                     const std::string& allowed) {
  if (!holds) add(fmt::format("{} = {}: must be {}", name, value, allowed));
}

void Problems::positive(const std::string& name, double value) {
  check(value > 0 && std::isfinite(value), name, value, "> 0 and finite");
}

void Problems::not_negative(const std::string& name, double value) {
  check(value >= 0 && std::isfinite(value), name, value, ">= 0 and finite");
}

void Problems::finite(const std::string& name, const Vector3& v) {
  if (!v.allFinite())
    add(fmt::format("{} = ({}, {}, {}): must be finite", name, v.x(), v.y(), v.z()));
}

void Problems::direction(const std::string& name, const Vector3& value) {
  finite(name, value);
  check(value.norm() > 0, name, value.norm(), "of some length");
}

void Problems::inertia(const std::string& name, const Matrix3& value, bool positive) {
  constexpr double kRelativeTolerance = 1e-9;  // for rounding
  if (!value.allFinite()) return add(name + ": must be finite");
  const double tolerance = kRelativeTolerance * value.norm();
  if ((value - value.transpose()).norm() > tolerance) return add(name + ": must be symmetric");
  const Vector3 moments =
      Eigen::SelfAdjointEigenSolver<Matrix3>(value, Eigen::EigenvaluesOnly).eigenvalues();
  const std::string text = fmt::format("{} with principal moments {}, {}, {} kg m2", name,
                                       moments.x(), moments.y(), moments.z());
  if (positive ? !(moments.x() > 0) : !(moments.x() >= -tolerance))
    add(text + (positive ? ": each must be > 0" : ": each must be >= 0"));
  else if (!(moments.z() <= moments.x() + moments.y() + tolerance))
    add(text + ": the largest must not exceed the sum of the others");
}

}  // namespace gurney
