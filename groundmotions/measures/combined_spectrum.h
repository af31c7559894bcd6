#pragma once

#include "groundmotions/measures/measure.h"

namespace gurney {

/// Pseudo-acceleration (5 %, at samples) of a record over periods, its components combined.
/// @param periods  >= 0 [s]
/// @returns [m/s2]
/// @throws Error for a component that the record does not have.
Eigen::VectorXd combined_spectrum(Combination combination, const Record& record,
                                  const Eigen::VectorXd& periods);

}  // namespace gurney
