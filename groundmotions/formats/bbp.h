#pragma once

#include <vector>

#include "groundmotions/formats/format.h"

namespace gurney::groundmotions {

/// Seismograms of the SCEC Broadband Platform (docs/formats/record_bbp.md): comments with `#` or
/// `%` that name unit and directions, then rows of time and three components.
bool recognises_bbp(const SourceFile& file);

/// @throws Error for velocities and displacements, missing units, rows of another length, what is
///         no number and times that are not evenly spaced.
std::vector<Component> read_bbp(const SourceFile& file, const ReadOptions& options);

}  // namespace gurney::groundmotions
