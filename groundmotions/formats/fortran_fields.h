#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "groundmotions/formats/source_file.h"

namespace gurney::groundmotions {

/// Numbers in columns of fixed width, such as 8F10.3, 16I5 or 8E10.4.
struct FortranFormat {
  std::size_t per_line = 0;  ///< numbers on a line
  std::size_t width = 0;     ///< characters of each
  std::size_t skip = 0;      ///< characters before the first
  char kind = 'F';           ///< 'F', 'E' or 'I'
  std::string text;          ///< as it was written, in capitals: "8F10.3"
};

/// The format that a spelling such as "(8f9.6)", "8F10.3", "5e14.7", "1P5E14.7" or "1X,10F7.3"
/// means; nothing for any other, also for several formats in one such as "(2(F8.3,F9.6))".
std::optional<FortranFormat> fortran_format(std::string_view spelling);

/// Meaning of an empty field: an error as among samples, or 0 as in a header, where `****` (a number
/// too long for its field) is NaN and real numbers may lack their point.
enum class EmptyField { kError, kZero };

/// Reads numbers from fixed columns, where they may stick together: "9012001" in 2I5 is 90 and
/// 12001. A line that does not fit its format is read by its blanks if it then has as many numbers
/// as it must have; what fits neither way is an error.
class FieldReader {
 public:
  FieldReader(const SourceFile& file, FileErrors& errors) : file_(file), errors_(errors) {}

  /// Reads `count` numbers, row by row.
  /// @param line   index from 0 of the first line; of the line behind the last one afterwards
  /// @param what   of the numbers, for messages: "samples"
  /// @returns `count` finite numbers, fewer if there were errors.
  std::vector<double> read(std::size_t& line, std::size_t count, const FortranFormat& format,
                           EmptyField empty, std::string_view what);

  /// Whether a line (index from 0) holds `count` numbers in just this format.
  bool fits(std::size_t line, std::size_t count, const FortranFormat& format) const;

 private:
  bool read_fields(std::size_t line, std::size_t count, const FortranFormat& format,
                   EmptyField empty, FileErrors& errors, std::vector<double>& values) const;
  bool read_freely(std::size_t line, std::size_t count, std::vector<double>& values) const;

  const SourceFile& file_;
  FileErrors& errors_;
};

/// Half of the last digit of a printed number: 0.005 of "11.90", 0.5 of "12".
double rounding_of(std::string_view printed);

/// The columns of a table of numbers from a line to the end of the file, blank lines at the end
/// apart.
/// @param first_line  index from 0
/// @returns format.per_line columns of one length; none after an error.
std::vector<Eigen::VectorXd> read_table(const SourceFile& file, std::size_t first_line,
                                        const FortranFormat& format, FileErrors& errors);

}  // namespace gurney::groundmotions
