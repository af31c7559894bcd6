#pragma once

#include <string>
#include <string_view>

namespace gurney::groundmotions {

/// `text` in UTF-8 on one line: bytes that are no UTF-8 are taken as Latin-1, as in station names
/// of older files, and control characters become blanks.
std::string readable(std::string_view text);

}  // namespace gurney::groundmotions
