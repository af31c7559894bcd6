#pragma once

#include <string>
#include <vector>

#include "groundmotions/formats/file_errors.h"
#include "groundmotions/formats/source_file.h"
#include "groundmotions/record/record.h"

namespace gurney::groundmotions {

/// The comment lines of Gurney's CSV (columns_csv.h) that are read back, where they are known:
///
///     # h1: azimuth 318 deg
///     # h1: start 1994-01-17T12:30:55.000Z
///
/// with `h2`, `vertical` (which has no azimuth) or `a` (the column of that name) in place of `h1`.
/// Starts are in UTC, to the millisecond.
std::string columns_csv_facts(const Record& record);

/// Reads them from the lines before the header row into the components of the file.
/// @param head  number of lines before the header row
void read_columns_csv_facts(const SourceFile& file, std::size_t head,
                            std::vector<Component>& components, FileErrors& errors);

}  // namespace gurney::groundmotions
