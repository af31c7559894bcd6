#pragma once

#include <vector>

#include "groundmotions/formats/format.h"

namespace gurney::groundmotions {

/// Volume 1 of the Iranian network of the Building and Housing Research Centre (BHRC): a section in
/// docs/formats/record_csmip.md.
bool recognises_bhrc(const SourceFile& file);

/// @returns L, V and T as the file has them.
/// @throws Error for other volumes, a wrong count, an unknown unit or text among the samples.
std::vector<Component> read_bhrc(const SourceFile& file, const ReadOptions& options);

}  // namespace gurney::groundmotions
