#pragma once

#include <Eigen/Core>

#include "groundmotions/buildings/modal_building.h"

namespace gurney::groundmotions {

/// Stiffness matrix of a shear building: floors joined to their neighbours by storey springs.
/// @param storeys  stiffness of each storey from the ground up, > 0 [N/m]
Eigen::MatrixXd shear_stiffness(const Eigen::VectorXd& storeys);

/// Stiffness of `storeys` equal storeys, scaled: 1 at the bottom, falling linearly to `top_ratio`.
/// @param top_ratio  > 0
Eigen::VectorXd tapered_storeys(int storeys, double top_ratio);

/// Stiffness matrix of a uniform cantilever that bends beside a uniform shear frame, both taking
/// the same displacement at `storeys` equally high floors; height and bending stiffness are 1:
///
///     K = F^-1 + K_shear,   F_ij = x_i^2 (3 x_j - x_i) / 6 for x_i <= x_j,   GA = alpha0^2.
///
/// With many storeys this is the continuum of Miranda & Taghavi (2005), Journal of Structural
/// Engineering 131(2), 203-211: alpha0 = 0 bends like a wall, infinity shears like a frame.
/// @param alpha0  >= 0; infinity: the shear frame alone, with GA = 1
Eigen::MatrixXd shear_flexure_stiffness(int storeys, double alpha0);

}  // namespace gurney::groundmotions
