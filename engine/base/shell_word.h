#pragma once

#include <string>

namespace gurney {

/// A text as one word of a POSIX shell: as it stands, or in single quotes.
std::string shell_word(const std::string& text);

}  // namespace gurney
