#pragma once

#include <string>
#include <vector>

#include "engine/config/table.h"
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

/// The array of tables `key` of a table, one step in each; docs/formats/processing.md:
///
///     processing = [{ step = "high_pass", corner_hz = 0.1 }, { step = "rotate", azimuth_deg = 30
///     }]
///
/// Errors are noted in the table's document. Empty if the key is absent. What depends on the
/// record, such as a corner above its Nyquist frequency, is for processed() to refuse.
std::vector<ProcessingStep> read_processing_steps(config::Table& table,
                                                  const std::string& key = "processing");

}  // namespace gurney::groundmotions
