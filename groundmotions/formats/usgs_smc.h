#pragma once

#include <vector>

#include "groundmotions/formats/format.h"

namespace gurney::groundmotions {

/// The SMC format of the US Geological Survey (docs/formats/record_smc.md): 11 lines of text, 48
/// integers, 50 reals, comments, then samples or pairs of time and sample in cm/s2.
bool recognises_smc(const SourceFile& file);

/// @throws Error for velocities, displacements and spectra, a sampling rate, count or peak that the
///         samples contradict, times that decrease, and a file that ends early or late.
std::vector<Component> read_smc(const SourceFile& file, const ReadOptions& options);

}  // namespace gurney::groundmotions
