#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace gurney::playback {

/// What a text in base64 stands for.
inline std::vector<std::uint8_t> bytes_of(const std::string& text) {
  static const std::string kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<std::uint8_t> bytes;
  std::uint32_t group = 0, bits = 0;
  for (const char c : text) {
    if (c == '=') break;
    group = group << 6 | static_cast<std::uint32_t>(kDigits.find(c));
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes.push_back(static_cast<std::uint8_t>(group >> bits & 255u));
  }
  return bytes;
}

}  // namespace gurney::playback
