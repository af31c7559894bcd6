#pragma once

#include <string>

namespace gurney::render {

/// Columns of a line of text: the environment variable COLUMNS, else the width of the terminal;
/// from 40 to 100, and 100 where the output is no terminal.
std::size_t columns();

/// How wide tables may be: as the terminal, or COLUMNS; npos where neither is known, as in files, whose
/// lines are read by programs.
std::size_t table_columns();

/// Breaks a text between words at columns(); lines after the first start with `indent` blanks.
/// @param used  columns before the first word
std::string wrapped(const std::string& text, std::size_t indent, std::size_t used);

enum class Colour { kAuto, kAlways, kNever };

/// Whether text is emphasised by the codes of a terminal. kAuto, which holds until another is
/// stated: where the output is a terminal, TERM is not "dumb", and NO_COLOR is empty or not set
/// (no-color.org).
void set_colour(Colour when);

/// A title or a heading, bold where text is emphasised. An empty text stays empty.
std::string bold(const std::string& text);

}  // namespace gurney::render
