#pragma once

#include <optional>
#include <string_view>

namespace gurney {

/// Blanks allowed around a number; 0x1a is the end of text in DOS files.
inline constexpr std::string_view kNumberBlanks = " \t\v\f\x1a";

/// The longest number at the start of `text`, which is shortened by it; nothing if there is none.
/// Decimal only, whatever the locale; Fortran's D is an E (`1.5D-03`); a leading '+' is fine; NaN,
/// infinities and numbers beyond the range of double are not numbers.
std::optional<double> take_number(std::string_view& text);

/// The number that `text` is, blanks around it apart.
std::optional<double> number(std::string_view text);

std::string_view trimmed(std::string_view text);

}  // namespace gurney
