#include "tests/groundmotions/buildings/matrix_exponential.h"

#include <unsupported/Eigen/MatrixFunctions>

namespace gurney {

Eigen::MatrixXd matrix_exponential(const Eigen::MatrixXd& a) { return a.exp(); }

}  // namespace gurney
