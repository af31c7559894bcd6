#pragma once

#include <vector>

#include "groundmotions/formats/format.h"

namespace gurney {

/// One number on each line and nothing else but blank lines and `#` comments. Such a file says
/// neither its unit nor its time step: the options must.
bool recognises_plain_column(const SourceFile& file);

/// @throws Error for what is no number, several numbers on a line, and options that lack the unit
///         or the time step.
std::vector<Component> read_plain_column(const SourceFile& file, const ReadOptions& options);

}  // namespace gurney
