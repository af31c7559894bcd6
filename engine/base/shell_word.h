#pragma once

#include <string>

namespace gurney {

/// A text as one word of a shell: as it stands, in single quotes, or, with control characters, as
/// bash's $'...'.
std::string shell_word(const std::string& text);

}  // namespace gurney
