#pragma once

#include <vector>

#include "groundmotions/formats/format.h"

namespace gurney::groundmotions {

/// The .cor.acc files of SIMBAD and REXEL, which hold records of ITACA (docs/formats/
/// record_esm.md): one component under lines `Key : value`, five numbers on a line that may stick
/// together at their signs.
bool recognises_simbad(const SourceFile& file);

/// @throws Error for velocities and displacements, missing or wrong header lines, a count that does
///         not match, and a peak far from that of the header.
std::vector<Component> read_simbad(const SourceFile& file, const ReadOptions& options);

}  // namespace gurney::groundmotions
