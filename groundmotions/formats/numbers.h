#pragma once

#include <Eigen/Core>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/base/number_text.h"
#include "groundmotions/formats/source_file.h"

namespace gurney::groundmotions {

/// `values` times `factor`.
Eigen::VectorXd scaled(const std::vector<double>& values, double factor);

/// Reads series of numbers from lines of Fortran or of people.
///
/// Numbers are apart by blanks or tabs, or by nothing where the next one starts with its sign and
/// has a decimal point: `.123E-01-.456E-02`. Exponents of three digits may have lost their letter,
/// as Fortran writes them: `.123-103`.
class NumberReader {
 public:
  /// @param separators  characters that part numbers besides blanks
  NumberReader(const SourceFile& file, FileErrors& errors, std::string_view separators = {});

  /// Reads a line (index from 0); what is no number becomes an error.
  /// @returns how many numbers it holds.
  std::size_t read_line(std::size_t index);

  /// To be called after the last line: a file that ends in the middle of a line was cut if its last
  /// number is shorter behind its point than all others, or ends left of its column where all
  /// columns are flush right.
  void check_end() const;

  const std::vector<double>& values() const { return values_; }

 private:
  /// Columns of the words of one line: where they begin and end, from 0.
  using Layout = std::vector<std::pair<std::size_t, std::size_t>>;

  void compare(const Layout& layout);
  void keep_tail();
  void read_word(std::string_view word, std::size_t line, std::size_t column);

  const SourceFile& file_;
  FileErrors& errors_;
  std::array<bool, 256> separates_;  ///< by byte
  std::vector<double> values_;
  std::vector<std::size_t> shortest_tails_;  ///< by column, of all but the last number
  std::size_t line_begin_ = 0;               ///< numbers before the line that is read
  std::size_t last_column_ = 0;              ///< of the last number, from 0
  std::size_t last_tail_ = 0;                ///< characters after its decimal point
  Layout layout_;                            ///< of the first line
  bool is_flush_right_ = false;              ///< words of several lengths end in the same columns
  bool all_in_columns_ = true, last_in_columns_ = true;  ///< all lines but the last; the last
};

/// The line (from 0) behind the last one of data, from `first` on: blank lines and lines with the
/// word `end` or `eof`, such as "*** End Data ***", may follow.
std::size_t data_end(const SourceFile& file, std::size_t first);

/// Reads all lines from `first` to data_end() and checks whether they were cut.
void read_to_end(const SourceFile& file, std::size_t first, NumberReader& reader);

}  // namespace gurney::groundmotions
