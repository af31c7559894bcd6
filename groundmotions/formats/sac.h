#pragma once

#include <vector>

#include "groundmotions/formats/format.h"

namespace gurney::groundmotions {

/// Binary files of the Seismic Analysis Code, header version 6 or 7, either byte order
/// (docs/formats/record_sac.md): one component. The file states its quantity at most, not its
/// unit: the options must.
bool recognises_sac(const SourceFile& file);

/// @throws Error for spectra, uneven samples, velocities, displacements and volts, a length that
///         is not that of the header, samples that are not finite, and options without a unit.
std::vector<Component> read_sac(const SourceFile& file, const ReadOptions& options);

}  // namespace gurney::groundmotions
