#pragma once

#include <cstddef>
#include <vector>

#include "groundmotions/formats/column_title.h"
#include "groundmotions/formats/plain_rows.h"

namespace gurney::groundmotions {

/// The titles of a table as the last lines of its text give them: in one row, `Time[s] Accel[g]`,
/// or with a row of units below or above them, `Time,Acc` and `[s],[g]` or `s,g`.
struct TableTitles {
  std::vector<ColumnTitle> titles;  ///< one for each column, or none
  std::vector<std::size_t> lines;   ///< of the header (from 0) that they are made of
  std::size_t line = 1;             ///< in the file, from 1, of the last of them
  bool are_components = false;      ///< a line says so: `components: E N Z`

  bool any() const { return !titles.empty(); }
};

/// @param count  columns of the table
/// Sentences and statements of as many words (`Units: g`, `cm/s2; dt=0.01`) are no titles. Without
/// titles a line such as `components: E N Z` names the columns but a first one of times.
TableTitles table_titles(const PlainRows& rows, std::size_t count);

}  // namespace gurney::groundmotions
