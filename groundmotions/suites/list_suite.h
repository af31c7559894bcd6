#pragma once

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

}  // namespace gurney::groundmotions
