#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "groundmotions/suites/suite.h"

namespace gurney::groundmotions {

/// Whether a file is a list of records: its first row, comments apart, begins with `name,`.
bool recognises_list_suite(const SourceFile& file);

/// A list of records (docs/formats/record_sets.md): a header row of `name` and then, in any order,
/// `file` (several apart by semicolons) with `channels`, or `h1`, `h2`, `vertical`, and `unit`,
/// `time_step_s`, `columns`, `count_m_per_s2`, `scale`; one row for each record. Paths are relative
/// to the folder of the list.
/// @throws Error with every unknown or doubled column, wrong number of cells, doubled name, missing
///         file, and number outside its range.
Suite read_list_suite(const SourceFile& file, const ReadOptions& options = {});

/// The text of a list that read_list_suite() reads as these records, with the scale of each. Of
/// records with one name the later ones are numbered: `name (2)`.
/// @param folder   of the list, to which paths are relative
/// @param comment  first line, without `#`
std::string list_suite_text(const std::vector<SuiteRecord>& records,
                            const std::filesystem::path& folder, const std::string& comment);

/// Whether a file is a search report of the PEER ground motion database (_SearchResults.csv).
bool recognises_peer_search_results(const SourceFile& file);

/// The records of a PEER search report: its table "Summary of Metadata of Selected Records". The
/// files lie in the folder of the report; those named `-`, `-----` or not at all are missing
/// components. Earthquake, station, magnitude, distances, Vs30, pulse period and lowest usable
/// frequency become facts. The report's own scale factors are facts, not applied.
///
/// Records of which no file is in the folder are left out with one note for all of them; if none is
/// there the report is refused. A record of which some files are absent, the vertical too, is
/// refused. A vertical that is not named is missing.
///
/// @throws Error without the table or without its columns of file names.
Suite read_peer_search_results(const SourceFile& file, const ReadOptions& options = {});

}  // namespace gurney::groundmotions
