#pragma once

#include <vector>

#include "groundmotions/formats/column_title.h"
#include "groundmotions/formats/file_errors.h"
#include "groundmotions/formats/format.h"
#include "groundmotions/formats/leading_numbers.h"
#include "groundmotions/formats/plain_columns.h"
#include "groundmotions/formats/plain_facts.h"
#include "groundmotions/formats/plain_rows.h"

namespace gurney::groundmotions {

/// Facts that all columns share.
struct PlainTable {
  const PlainRows& rows;
  const PlainFacts& facts;
  const LeadingNumbers& leading;
  const ReadOptions& options;
  FileErrors& errors;
  std::size_t title_line = 1;          ///< in the file, from 1
  bool some_state_a_unit = false;      ///< titles of columns of accelerations do
  mutable bool unit_reported = false;  ///< as missing or contradicted, once for all columns
};

/// The components of a table: a column each, with unit and direction as title, text and user say.
/// Columns of other quantities are left out, with a warning, where all others are accelerations by
/// their titles; else they are errors.
/// @param titles  one for each column, or none
std::vector<Component> table_components(PlainColumns columns, std::vector<ColumnTitle> titles,
                                        const PlainTable& table);

/// The component of numbers that are samples row by row.
std::vector<Component> only_component(const PlainTable& table);

}  // namespace gurney::groundmotions
