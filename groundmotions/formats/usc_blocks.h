#pragma once

#include <vector>

#include "groundmotions/formats/format.h"

namespace gurney::groundmotions {

/// Processed files of USC that name their blocks "DATA TYPE=AC", VL and DP.
bool recognises_usc_blocks(const SourceFile& file);

/// @returns the acceleration of each component of the file.
/// @throws Error if a block has not the number of samples it states, or no block is acceleration.
std::vector<Component> read_usc_blocks(const SourceFile& file, const ReadOptions& options);

}  // namespace gurney::groundmotions
