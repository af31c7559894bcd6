#pragma once

#include "groundmotions/suites/suite.h"

namespace gurney::groundmotions {

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
