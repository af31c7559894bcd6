#pragma once

#include <Eigen/Core>
#include <optional>
#include <string_view>
#include <vector>

#include "groundmotions/formats/fortran_fields.h"

namespace gurney::groundmotions {

/// Text behind the colon of the first line in `lines` that starts with `key` (blanks before
/// it apart), trimmed; nothing if there is none.
/// @param line  index of that line from 0
std::optional<std::string_view> value_behind(const std::vector<std::string_view>& lines,
                                             std::string_view key, std::size_t& line);

/// Text behind the colon of a line that must be there.
std::string_view needed_behind(const std::vector<std::string_view>& lines, std::string_view key,
                               std::size_t& line, FileErrors& errors);

/// Half of the last digit of a printed number: 0.005 of "11.90", 0.5 of "12".
double rounding_of(std::string_view printed);

/// The columns of a table of numbers from a line to the end of the file, blank lines at the end
/// apart.
/// @param first_line  index from 0
/// @returns format.per_line columns of one length; none after an error.
std::vector<Eigen::VectorXd> read_table(const SourceFile& file, std::size_t first_line,
                                        const FortranFormat& format, FileErrors& errors);

}  // namespace gurney::groundmotions
