#pragma once

#include <vector>

#include "groundmotions/formats/format.h"

namespace gurney::groundmotions {

/// K-NET and KiK-net ASCII (docs/formats/record_knet.md): one component in counts with a scale
/// factor in gal.
bool recognises_knet(const SourceFile& file);

/// The mean over the whole record is taken off, as the peak in the header assumes.
/// @throws Error for missing or wrong header lines, a count of samples that is not the duration
///         times the sampling frequency, and a peak far from that of the header.
std::vector<Component> read_knet(const SourceFile& file, const ReadOptions& options);

}  // namespace gurney::groundmotions
