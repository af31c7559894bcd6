#pragma once

#include <string>
#include <vector>

#include "studies/analysis/study_sensitivity.h"

namespace gurney::study {

/// Inputs of a study's Saltelli design in their order, `variable mass_kg`, `group treads` or
/// `record`; none: it has no such design.
std::vector<std::string> design_inputs(const StudyData& data);

/// First-order and total indices (sobol_indices) of the inputs of a Saltelli design.
///
/// Of each angle and level the output's mean is taken off, so that the variance is that under one
/// of them. A point counts if all its runs do.
/// @throws Error as study_sensitivity() does, and where fewer than kFewestRuns points are whole
StudySensitivity designed_sensitivity(const ConfigurationView& side,
                                      const SensitivityRequest& request);

}  // namespace gurney::study
