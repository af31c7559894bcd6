#pragma once

#include <vector>

#include "groundmotions/formats/format.h"

namespace gurney::groundmotions {

/// Volumes 1 and 2 of the California Strong Motion Instrumentation Program (CSMIP, also CDMG or
/// DMG) and RENADIC's volume 1 in the same layout (docs/formats/record_csmip.md).
bool recognises_csmip(const SourceFile& file);

/// @returns the acceleration of each channel of the file.
/// @throws Error for volume 3 (response spectra) and what caltech_components.h says.
std::vector<Component> read_csmip(const SourceFile& file, const ReadOptions& options);

}  // namespace gurney::groundmotions
