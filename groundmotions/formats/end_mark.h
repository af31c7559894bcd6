#pragma once

#include "groundmotions/formats/numbers.h"
#include "groundmotions/formats/source_file.h"

namespace gurney::groundmotions {

/// The line (from 0) behind the last one of data, from `first` on: blank lines and lines with the
/// word `end` or `eof`, such as "*** End Data ***", may follow.
std::size_t data_end(const SourceFile& file, std::size_t first);

/// Reads all lines from `first` to data_end() and checks whether they were cut.
void read_to_end(const SourceFile& file, std::size_t first, NumberReader& reader);

}  // namespace gurney::groundmotions
