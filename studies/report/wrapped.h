#pragma once

#include <string>

namespace gurney::report {

/// Breaks a text between words at 100 columns; lines after the first start with `indent` blanks.
/// @param used  columns before the first word
std::string wrapped(const std::string& text, std::size_t indent, std::size_t used);

}  // namespace gurney::report
