#pragma once

#include <string>

namespace gurney::render {

enum class Colour { kAuto, kAlways, kNever };

/// Whether text is emphasised by the codes of a terminal. kAuto, which holds until another is
/// stated: where the output is a terminal, TERM is not "dumb", and NO_COLOR is empty or not set
/// (no-color.org).
void set_colour(Colour when);

/// A title or a heading, bold where text is emphasised. An empty text stays empty.
std::string bold(const std::string& text);

}  // namespace gurney::render
