#include "groundmotions/formats/readable.h"

#include <algorithm>

namespace gurney {

namespace {

unsigned byte_at(std::string_view text, std::size_t i) {
  return static_cast<unsigned char>(text[i]);
}

/// Bytes of the character that `text` starts with in UTF-8 (RFC 3629: no overlong form, no
/// surrogate, nothing above U+10FFFF); 0 if there is none.
std::size_t length_of_character(std::string_view text) {
  const unsigned first = byte_at(text, 0);
  if (first < 0x80) return 1;
  const std::size_t length = first < 0xc2 ? 0 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
  if (length == 0 || first > 0xf4 || text.size() < length) return 0;
  const auto follows = [](unsigned char c) { return (c & 0xc0) == 0x80; };
  if (!std::ranges::all_of(text.substr(1, length - 1), follows)) return 0;
  const unsigned second = byte_at(text, 1);
  const bool is_overlong = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
  const bool is_no_character = (first == 0xed && second > 0x9f) || (first == 0xf4 && second > 0x8f);
  return is_overlong || is_no_character ? 0 : length;
}

/// C0, DEL and C1 of Unicode.
bool is_control(unsigned code) { return code < 0x20 || (code >= 0x7f && code < 0xa0); }

}  // namespace

std::string readable(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t length = length_of_character(text);
    const unsigned byte = byte_at(text, 0);
    const unsigned code = length == 2 ? (byte & 0x1f) << 6 | (byte_at(text, 1) & 0x3f) : byte;
    if (length <= 2 && is_control(code)) {
      result += ' ';
    } else if (length > 0) {
      result += text.substr(0, length);
    } else {  // Latin-1 has the first 256 codes of Unicode
      result += static_cast<char>(0xc0 | byte >> 6);
      result += static_cast<char>(0x80 | (byte & 0x3f));
    }
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return result;
}

}  // namespace gurney
