#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "groundmotions/formats/file_errors.h"
#include "groundmotions/formats/source_file.h"

namespace gurney::groundmotions {

/// A text file of numbers, cut into a header of text, rows of numbers and an end mark. Numbers are
/// apart by blanks, tabs, commas or semicolons; `#`, `%` and `//` start a comment line anywhere.
struct PlainRows {
  std::vector<std::string_view> header;   ///< lines of text and comments before the numbers
  std::vector<std::size_t> header_lines;  ///< of them in the file, from 1
  std::vector<double> values;             ///< row after row
  std::vector<std::size_t> lengths;       ///< of the rows, each at least 1
  std::vector<std::size_t> lines;         ///< of the rows in the file, from 1
  std::vector<std::string_view> end;      ///< last lines with the word `end`

  /// Commas part the numbers and none has a point: they may be decimal commas.
  bool doubtful_commas = false;

  /// The numbers in each row but the last one, which may have fewer; 0 if they differ.
  std::size_t width() const;
};

/// Whether a line holds words rather than numbers, right or wrong.
bool is_text_line(std::string_view line);

/// Whether a row of numbers comes after at most 40 lines of text.
bool has_plain_rows(const SourceFile& file);

/// What is no number after the first row, save an end mark, and empty cells become errors.
PlainRows plain_rows(const SourceFile& file, FileErrors& errors);

/// The cells of the last line of text, if it names `count` columns: `Time[s] Accel[g]`; else none.
/// A bracket belongs to the word before it; titles of several words are apart by two blanks.
std::vector<std::string> column_titles(const PlainRows& rows, std::size_t count);

}  // namespace gurney::groundmotions
