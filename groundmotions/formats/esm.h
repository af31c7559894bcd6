#pragma once

#include <vector>

#include "groundmotions/formats/format.h"

namespace gurney::groundmotions {

/// ASCII of ESM, ITACA (old and new header) and AFAD (docs/formats/record_esm.md): one component
/// under lines `KEY: value`, one value on a line.
bool recognises_esm(const SourceFile& file);

/// @throws Error for velocities, displacements and spectra, missing or wrong header lines, a count
///         that does not match, and a peak far from that of the header.
std::vector<Component> read_esm(const SourceFile& file, const ReadOptions& options);

}  // namespace gurney::groundmotions
