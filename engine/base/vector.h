#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

/// Axes: right-handed, z up. Floor axes are fixed to the floor; item axes have x forward, y left
/// and their origin on the floor below the middle of the item. SI units throughout.
namespace gurney {

using Vector2 = Eigen::Vector2d;
using Vector3 = Eigen::Vector3d;
using Matrix2 = Eigen::Matrix2d;
using Matrix3 = Eigen::Matrix3d;
using Quaternion = Eigen::Quaterniond;

/// The larger of two numbers; one that is no number stays.
inline double larger_or_nan(double a, double b) { return a >= b || a != a ? a : b; }

}  // namespace gurney
