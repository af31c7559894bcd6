#pragma once

#include <vector>

#include "groundmotions/processing/step.h"
#include "groundmotions/record/record.h"

namespace gurney::groundmotions {

/// The record after all steps, in their order; every step does the same to all components.
///
/// Each step adds one line with its parameters to record.processing, and what it did to the largest
/// velocity and displacement left at the end of a component. A step that undoes the work of one
/// before it, and a cut where a component moves faster than 0.05 m/s, add to record.warnings. Start
/// times follow the first sample.
///
/// @throws Error for what a step refuses: "record 'name', step 2 (high_pass): ...".
Record processed(Record record, const std::vector<ProcessingStep>& steps);

}  // namespace gurney::groundmotions
