#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace gurney {

/// One cell of a row.
struct CsvCell {
  std::string text;        ///< without the blanks and quotes around it
  std::size_t column = 1;  ///< where it starts, from 1
};

/// The cells of a comma-separated row. A cell in double quotes may hold commas; a doubled quote
/// inside stands for one (RFC 4180).
std::vector<CsvCell> csv_row(std::string_view line);

}  // namespace gurney
