#pragma once

#include <vector>

#include "groundmotions/formats/format.h"

namespace gurney::groundmotions {

/// Raw text files of the national strong motion network of Turkey as it gave them out before AFAD
/// took the layout of ESM (docs/formats/record_nsmn.md): lines `KEY : value`, the names of the
/// columns, then rows of north, east, up.
bool recognises_nsmn(const SourceFile& file);

/// @throws Error for statements that are missing or disagree, another number of rows than stated,
///         and samples that are no numbers.
std::vector<Component> read_nsmn(const SourceFile& file, const ReadOptions& options);

}  // namespace gurney::groundmotions
