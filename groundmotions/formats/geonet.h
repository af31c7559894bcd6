#pragma once

#include <vector>

#include "groundmotions/formats/format.h"

namespace gurney::groundmotions {

/// Volumes V1A (uncorrected) and V2A (corrected) of GNS Science, New Zealand
/// (docs/formats/record_geonet.md): three components in one file, each with 16 lines of text, 40
/// integers, 60 reals, then accelerations and, in V2A, velocities and displacements.
bool recognises_geonet(const SourceFile& file);

/// @throws Error for counts, time steps and peaks that disagree, a missing component, samples that
///         are no numbers, and a file that ends early or late.
std::vector<Component> read_geonet(const SourceFile& file, const ReadOptions& options);

}  // namespace gurney::groundmotions
