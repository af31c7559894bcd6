#pragma once

#include <vector>

#include "groundmotions/formats/format.h"

namespace gurney::groundmotions {

/// Text of numbers without a layout of its own (docs/formats/record_plain.md): one column, samples
/// row by row, or a table with or without times; text before and an end mark after the numbers.
bool recognises_plain_text(const SourceFile& file);

/// @throws Error if unit, time step or the meaning of the columns are neither stated by the file
///         nor by the options, for spectra, velocities and displacements that say so, what is no
///         number, rows of unequal length, and times that are not even.
std::vector<Component> read_plain_text(const SourceFile& file, const ReadOptions& options);

}  // namespace gurney::groundmotions
