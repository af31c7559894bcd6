#pragma once

#include <string_view>

namespace gurney {

/// Bytes of the character that `text`, not empty, starts with in UTF-8 (RFC 3629: no overlong form,
/// no surrogate, nothing above U+10FFFF); 0 if there is none.
std::size_t utf8_length(std::string_view text);

}  // namespace gurney
