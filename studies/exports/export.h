#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace gurney::study {

/// Takes a file of an export: its name, without folder, and its bytes.
using TakeFile = std::function<void(const std::string& name, std::string_view bytes)>;

/// A text as a name of a file or an identifier: what is not a letter, digit or underscore becomes
/// an underscore. Without letters and digits it is `otherwise`.
std::string plain_identifier(const std::string& text, const std::string& otherwise);

/// A cell of a CSV file (RFC 4180): quoted where it must be, control characters as `\x1b`. A text
/// that a spreadsheet would compute, such as `=1+1`, gets an apostrophe before it.
std::string csv_cell(const std::string& text);
/// The shortest text that reads back as the same number; NaN: empty.
std::string csv_cell(double value);

/// Cells and the end of the line.
std::string csv_line(const std::vector<std::string>& cells);

}  // namespace gurney::study
