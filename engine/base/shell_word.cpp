#include "engine/base/shell_word.h"

#include <fmt/format.h>

#include "engine/base/printable.h"

namespace gurney {

std::string shell_word(const std::string& text) {
  static const std::string kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./+=:,@%";
  if (!text.empty() && text.find_first_not_of(kPlain) == std::string::npos) return text;
  // A word with control characters is $'...': a terminal shows it, and the shell reads it back.
  const bool escaped = find_control_character(text) != std::string::npos;
  std::string quoted = escaped ? "$'" : "'";
  for (const char c : text)
    if (c == '\'')
      quoted += escaped ? "\\'" : "'\\''";
    else if (escaped && c == '\\')
      quoted += "\\\\";
    else if (const auto byte = static_cast<unsigned char>(c);
             escaped && (byte < 0x20 || byte > 0x7e))
      quoted += fmt::format("\\x{:02x}", byte);
    else
      quoted += c;
  return quoted + "'";
}

}  // namespace gurney
