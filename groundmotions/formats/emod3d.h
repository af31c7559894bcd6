#pragma once

#include <vector>

#include "groundmotions/formats/format.h"

namespace gurney::groundmotions {

/// Text of EMOD3D and ucgmsim (docs/formats/record_ucgmsim.md): a line `station component title`, a
/// line `npts dt hh mm ss distance azimuth back-azimuth`, then numbers. The file states no unit.
bool recognises_emod3d(const SourceFile& file);

/// @throws Error without options.unit, for a wrong header and a count that does not match.
std::vector<Component> read_emod3d(const SourceFile& file, const ReadOptions& options);

}  // namespace gurney::groundmotions
