#pragma once

#include <string>
#include <vector>

#include "groundmotions/formats/format.h"

namespace gurney::groundmotions {

/// Gurney's own text format (docs/formats/record_csv.md): `#` comments, a header row such as
/// `time_s, x_m_per_s2, y_m_per_s2, z_m_per_s2`, then rows of numbers. Some
/// comments are read: columns_csv_facts.h.
bool recognises_columns_csv(const SourceFile& file);

/// @throws Error for unknown, doubled or missing columns, rows of another length, what is no
///         number, times that are not evenly spaced, a file that ends within a row,
///         and azimuths or starts that cannot be read.
std::vector<Component> read_columns_csv(const SourceFile& file, const ReadOptions& options);

/// A record in this format, accelerations in m/s2, with its azimuths and starts
/// (columns_csv_facts.h).
/// @param comments  lines without `#` and line ends
/// @param digits    after the point
std::string columns_csv_text(const Record& record, const std::vector<std::string>& comments,
                             int digits = 5);

}  // namespace gurney::groundmotions
