#pragma once

#include <Eigen/Core>

#include "groundmotions/measures/combination.h"
#include "groundmotions/record/record.h"

namespace gurney::groundmotions {

/// Pseudo-acceleration at samples of a record, its components combined at each period.
/// @param periods  >= 0 [s]
/// @param damping  in [0, 1)
/// @returns [m/s2]
/// @throws Error for a component that the record does not have, and for the resultant, which no
///         spectrum has.
Eigen::VectorXd combined_spectrum(Combination combination, const Record& record,
                                  const Eigen::VectorXd& periods, double damping = 0.05);

}  // namespace gurney::groundmotions
