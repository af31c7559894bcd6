#pragma once

#include "studies/convergence/convergence.h"

namespace gurney::study {

/// |a - b| over the larger of both; 0 where they differ by `smallest` or less.
double relative_change(double a, double b, double smallest);

/// Fills change, order, verdicts of a number from its values.
/// @param smallest  change that counts as none, in the number's unit, >= 0
void judge(ConvergedNumber& number, const std::vector<Variant>& variants,
           const SimulationSettings& settings, double tolerance, double smallest);

}  // namespace gurney::study
