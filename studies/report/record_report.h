#pragma once

#include <string>
#include <utility>
#include <vector>

#include "groundmotions/measures/summary.h"
#include "groundmotions/record/record.h"
#include "studies/findings/findings.h"

namespace gurney::report {

/// Name and value of something known of a record besides its files, such as magnitude.
using RecordFact = std::pair<std::string, std::string>;

/// Everything about one record: files, samples, header, processing, intensity measures of the
/// components and of RotD50, what is left at the end, warnings.
findings::Section record_report(
    const groundmotions::Record& record, const std::vector<RecordFact>& facts,
    const std::vector<groundmotions::Measure>& measures = groundmotions::common_measures());

/// Doubts about a record: warnings of reading, of amplitudes, of what is left at the end.
std::vector<std::string> record_findings(const groundmotions::Record& record);

/// One line for each record, and the lines above them; docs/records.md explains the columns.
/// @param width  of a line; columns are left out where it is too narrow for all
std::string record_table_head(std::size_t width = std::string::npos);
std::string record_table_line(const groundmotions::Record& record,
                              std::size_t width = std::string::npos);

/// Eight hexadecimal digits that identify the files of a record: of the SHA-256 of its file or, of
/// several, of the SHA-256 of their hashes one after the other, h1 first. "-" for no file.
std::string short_hash(const groundmotions::Record& record);

}  // namespace gurney::report
