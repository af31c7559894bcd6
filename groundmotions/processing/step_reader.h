#pragma once

#include <string>
#include <vector>

#include "engine/config/table.h"
#include "groundmotions/processing/step.h"

namespace gurney::groundmotions {

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
