#pragma once

#include <vector>

#include "groundmotions/formats/format.h"

namespace gurney::groundmotions {

/// Volumes 1 and 2 of the University of Southern California in the layout of Trifunac and Lee
/// (1973), whatever the file is called (docs/formats/record_usc.md).
bool recognises_usc(const SourceFile& file);

/// @throws Error for volume 3 (response spectra) and what caltech_components.h says.
std::vector<Component> read_usc(const SourceFile& file, const ReadOptions& options);

}  // namespace gurney::groundmotions
