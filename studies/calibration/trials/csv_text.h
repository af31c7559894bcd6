#pragma once

#include <string>
#include <vector>

#include "engine/base/diagnostics.h"

namespace gurney::calibration {

/// A cell, or the value of a key, with its place.
struct TextCell {
  std::string text;  ///< without blanks around it
  int line = 0, column = 0;
};

/// `# key = value`.
struct CsvFact {
  TextCell key, value;
};

/// A CSV file with facts above its table, as text.
struct CsvText {
  std::string file;
  std::vector<CsvFact> facts;
  std::vector<TextCell> header;
  std::vector<std::vector<TextCell>> rows;  ///< each as long as the header
};

/// Errors of one file, each with its place.
class CsvErrors {
 public:
  explicit CsvErrors(std::string file) : file_(std::move(file)) {}

  void note(const TextCell& at, const std::string& message);
  void note(int line, int column, const std::string& message);
  std::size_t count() const { return errors_.count(); }

  /// @throws Error with the errors by line, the first 20 in full.
  void finish() const;

 private:
  std::string file_;
  Diagnostics errors_;
};

/// Reads what a spreadsheet exports: cells apart by commas, decimal points, any line ends, a byte
/// order mark, empty cells at the ends of rows, cells in quotes. Notes rows that are longer or
/// shorter than the header, lines with `#` that are no `# key = value`, and such lines below the
/// header.
/// @throws Error if the file is missing, cannot be read or has no table; after three lines with
///         control characters, with what was noted so far
CsvText read_csv_text(const std::string& file, CsvErrors& errors);

}  // namespace gurney::calibration
