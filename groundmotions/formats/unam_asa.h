#pragma once

#include <vector>

#include "groundmotions/formats/format.h"

namespace gurney::groundmotions {

/// The standard acceleration file (Archivo Estandar de Aceleracion) of the Mexican strong motion
/// base (docs/formats/record_unam.md): a Spanish header, then a column for each channel.
bool recognises_unam(const SourceFile& file);

/// @throws Error for statements that are missing or disagree, fewer rows than stated, and samples
///         that are no numbers. More rows than stated are a warning.
std::vector<Component> read_unam(const SourceFile& file, const ReadOptions& options);

}  // namespace gurney::groundmotions
