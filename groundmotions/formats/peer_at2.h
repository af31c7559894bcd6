#pragma once

#include <vector>

#include "groundmotions/formats/format.h"

namespace gurney::groundmotions {

/// PEER ground motion files (docs/formats/record_at2.md): a text header that ends with the number
/// of samples and the time step in one of its spellings, then the samples row by row.
bool recognises_peer_at2(const SourceFile& file);

/// @throws Error for a velocity or displacement file (VT2, DT2), an unknown unit, a missing time
///         step, text among the numbers, or a count that is not NPTS.
std::vector<Component> read_peer_at2(const SourceFile& file, const ReadOptions& options);

}  // namespace gurney::groundmotions
