#include "groundmotions/formats/readable.h"

#include <algorithm>

#include "engine/base/utf8.h"

namespace gurney::groundmotions {

namespace {

unsigned byte_at(std::string_view text, std::size_t i) {
  return static_cast<unsigned char>(text[i]);
}

/// C0, DEL and C1 of Unicode.
bool is_control(unsigned code) { return code < 0x20 || (code >= 0x7f && code < 0xa0); }

}  // namespace

std::string readable(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
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

}  // namespace gurney::groundmotions
