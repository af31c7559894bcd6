#pragma once

#include <memory>
#include <string>

#include "groundmotions/formats/source_file.h"

namespace gurney::groundmotions {

/// A file of plain numbers as its cells mean it: without quotes, with decimal points, and with
/// seconds from the first row where rows begin with a date or a clock time.
struct PlainCells {
  /// With the same lines and columns as the original; null if nothing had to be replaced.
  std::unique_ptr<SourceFile> file;
  std::string first_time;  ///< "2010-02-27 06:34:14.005" of the first row, as written; may be empty
  bool decimal_commas = false;

  /// Cells apart by semicolons have commas and points: neither can be taken for the decimal mark.
  bool mixed_marks = false;
};

/// Whether a line begins with a date and a clock time, or a clock time, and numbers follow.
bool is_dated_row(std::string_view line);

PlainCells plain_cells(const SourceFile& file);

}  // namespace gurney::groundmotions
