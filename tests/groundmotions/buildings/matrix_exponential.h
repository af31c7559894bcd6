#pragma once

#include <Eigen/Core>

namespace gurney {

/// exp(A) by Eigen, which takes the compiler seconds in every source that instantiates it.
Eigen::MatrixXd matrix_exponential(const Eigen::MatrixXd& a);

}  // namespace gurney
