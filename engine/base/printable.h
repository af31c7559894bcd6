#pragma once

#include <string>
#include <string_view>

namespace gurney {

/// Place of the first control character (C0, DEL, C1) other than a tab and the line ends LF and
/// CR LF; npos: there is none.
std::size_t find_control_character(std::string_view text);

/// The text with each byte of such a character, and each that is no UTF-8, written as `\x1b`: a
/// terminal shows it and does not obey it, and the result is text for XML and JSON.
std::string printable(std::string_view text);

/// printable(), with the five characters of markup as entities: text and attribute values of HTML, XML and SVG.
std::string xml_text(std::string_view text);

/// Each line of more than 4000 bytes without its middle, of which the length is stated: messages
/// quote names and values of files.
std::string shortened(std::string_view lines);

}  // namespace gurney
