#pragma once

#include <string>
#include <vector>

#include "groundmotions/formats/format.h"
#include "groundmotions/formats/source_file.h"
#include "groundmotions/record/record.h"

namespace gurney::groundmotions {

/// @throws Error where a file of the record could not be read again: for a time step or a peak beyond the
///         limits of files
void require_readable(const Record& record);

/// A record in this format, accelerations in m/s2, with its azimuths and starts
/// (columns_csv_facts.h).
/// @param comments  lines without `#` and line ends
/// @param digits    after the point
std::string columns_csv_text(const Record& record, const std::vector<std::string>& comments,
                             int digits = 5);

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

/// A component as a PEER AT2 file: four lines of header, then accelerations in g, five in a row
/// with eight significant digits.
/// @param title  first line of the header
/// @param event  second line, before the name of the component; commas end its fields
std::string at2_text(const Component& component, const std::string& title,
                     const std::string& event);

}  // namespace gurney::groundmotions
