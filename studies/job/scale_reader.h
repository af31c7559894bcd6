#pragma once

#include "engine/base/config/table.h"
#include "studies/job/job.h"

namespace gurney {

/// Reads `scale_to` of a record, such as
/// `{ measure = "Sa(1.0)", component = "RotD50", value = 0.6, unit = "g" }`. Mistakes are noted in
/// the table's document.
ScaleTo read_scale_to(config::Table& table);

/// The record scaled so that the measure has the value.
/// @throws Error for a measure that is zero or that scaling does not change.
Record scaled_to(const Record& record, const ScaleTo& request);

}  // namespace gurney
