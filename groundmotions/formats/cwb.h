#pragma once

#include <vector>

#include "groundmotions/formats/format.h"

namespace gurney::groundmotions {

/// Text files of the Central Weather Bureau (now Administration), Taiwan
/// (docs/formats/record_cwb.md): lines of `#Key: value`, then rows of time, up, north, east.
bool recognises_cwb(const SourceFile& file);

/// @throws Error for statements that are missing or disagree, times that are not evenly spaced, a
///         length that differs from the stated one by more than a second, and samples that are no
///         numbers.
std::vector<Component> read_cwb(const SourceFile& file, const ReadOptions& options);

}  // namespace gurney::groundmotions
