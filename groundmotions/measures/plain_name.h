#pragma once

#include <cctype>
#include <string>
#include <string_view>

namespace gurney::groundmotions {

/// `text` without blanks, in small letters: what names of measures are compared by.
inline std::string plain_name(std::string_view text) {
  std::string result;
  for (const char c : text)
    if (!std::isspace(static_cast<unsigned char>(c)))
      result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

}  // namespace gurney::groundmotions
