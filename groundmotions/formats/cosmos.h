#pragma once

#include <vector>

#include "groundmotions/formats/format.h"

namespace gurney::groundmotions {

/// COSMOS Strong Motion Data Format, version 1.20: stages V0 (raw counts), V1 and V2
/// (docs/formats/record_cosmos.md).
bool recognises_cosmos(const SourceFile& file);

/// @returns the channels of acceleration. Raw counts are converted by options.si_per_count, or else
///          by the sensitivity of the sensor and the recorder that the header states.
/// @throws Error for spectra (V3), files without acceleration, units that are not acceleration,
///         counts without a sensitivity, and samples that are not as many as stated.
std::vector<Component> read_cosmos(const SourceFile& file, const ReadOptions& options);

}  // namespace gurney::groundmotions
