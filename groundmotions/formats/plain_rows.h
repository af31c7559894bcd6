#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

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

/// A rule such as "-----" or "---***---", which parts a header.
bool is_rule(std::string_view line);

/// The first line (from 0) that is neither blank, comment nor text, after at most 40 lines of text.
std::optional<std::size_t> first_plain_row(const SourceFile& file);

/// Whether that line is a row of numbers.
bool has_plain_rows(const SourceFile& file);

/// The line and column (from 1) of what is neither a number nor text where such a row should begin;
/// nothing if there is only text. The content of a file that is no record is never quoted.
struct PlainFault {
  std::size_t line = 1, column = 1;
};
std::optional<PlainFault> plain_fault(const SourceFile& file);

/// Reads the rows: what is no number after the first row, save an end mark, and empty cells become errors.
PlainRows plain_rows(const SourceFile& file, FileErrors& errors);

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
