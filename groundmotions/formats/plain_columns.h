#pragma once

#include <optional>
#include <string>
#include <vector>

#include "groundmotions/formats/file_errors.h"
#include "groundmotions/formats/format.h"
#include "groundmotions/formats/plain_rows.h"
#include "groundmotions/formats/table_titles.h"

namespace gurney::groundmotions {

/// Meaning of the numbers in plain rows.
struct PlainColumns {
  enum class Kind { kTime, kComponent, kSkip };
  struct Column {
    Kind kind = Kind::kComponent;
    std::optional<Direction> direction;
  };

  bool samples = false;         ///< one component, row by row; `columns` is empty
  std::vector<Column> columns;  ///< one for each number of a row
  std::string skipped_index;    ///< title of a first column that counts the rows; may be empty
};

/// @param options  `columns` if not empty, else: one number in a row, a column that grows from row to
///                 row (a time: the first, or the one with that title), or titles that all are of
///                 accelerations say it
/// @param stated   the file states how many samples it has, as many as it has numbers
/// Errors: names that are unknown or repeated, no component, another number of columns, rows of
/// unequal length, and rows that do not say what they are.
PlainColumns plain_columns(const PlainRows& rows, const TableTitles& titles, bool stated,
                           const ReadOptions& options, FileErrors& errors);

}  // namespace gurney::groundmotions
