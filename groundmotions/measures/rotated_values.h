#pragma once

#include "groundmotions/measures/measure.h"
#include "groundmotions/measures/rotation.h"

namespace gurney::groundmotions {

/// A measure over the angles of rotation.h; its percentiles are RotD. Not for spectral measures,
/// which are combined at each period.
RotatedValues rotated_values(const Measure& measure, double time_step, const Eigen::VectorXd& h1,
                             const Eigen::VectorXd& h2);

}  // namespace gurney::groundmotions
