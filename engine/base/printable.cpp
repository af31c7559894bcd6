#include "engine/base/printable.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "engine/base/utf8.h"

namespace gurney {
namespace {

/// Whether the character of `length` bytes that `text` starts with is one.
bool is_control(std::string_view text, std::size_t length) {
  const auto byte = static_cast<unsigned char>(text[0]);
  if (text.starts_with("\r\n") || byte == '\t' || byte == '\n') return false;
  if (length == 2) return byte == 0xc2 && static_cast<unsigned char>(text[1]) < 0xa0;  // C1
  return byte < 0x20 || byte == 0x7f;
}

constexpr std::size_t kLongestLine = 4000, kKeptStart = 3000, kKeptEnd = 800;  // [bytes]

/// The first byte of the character of UTF-8 that has the byte `at`.
std::size_t start_of_character(std::string_view text, std::size_t at) {
  while (at > 0 && (static_cast<unsigned char>(text[at]) & 0xc0) == 0x80) --at;
  return at;
}

std::string without_middle(std::string_view line) {
  if (line.size() <= kLongestLine) return std::string(line);
  const std::size_t from = start_of_character(line, kKeptStart),
                    to = start_of_character(line, line.size() - kKeptEnd);
  return fmt::format("{} [... {} bytes omitted ...] {}", line.substr(0, from), to - from,
                     line.substr(to));
}

}  // namespace

std::size_t find_control_character(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::string_view rest = text.substr(at);
    const std::size_t length = std::max<std::size_t>(utf8_length(rest), 1);
    if (is_control(rest, length)) return at;
    at += length;
  }
  return std::string_view::npos;
}

std::string printable(std::string_view text) {
  const auto is_plain = [](char c) { return ' ' <= c && c <= '~'; };
  if (std::ranges::all_of(text, is_plain)) return std::string(text);
  std::string result;
  while (!text.empty()) {
    const std::size_t length = utf8_length(text), bytes = std::max<std::size_t>(length, 1);
    if (length > 0 && !is_control(text, length))
      result += text.substr(0, length);
    else
      for (const char byte : text.substr(0, bytes))
        result += fmt::format("\\x{:02x}", static_cast<unsigned char>(byte));
    text.remove_prefix(bytes);
  }
  return result;
}

std::string xml_text(std::string_view text) {
  constexpr std::string_view kMarkup = "&<>\"'";
  constexpr std::array kEntities = {"&amp;", "&lt;", "&gt;", "&quot;", "&#39;"};
  std::string result;
  for (const char c : printable(text)) {
    const std::size_t at = kMarkup.find(c);
    if (at == std::string_view::npos)
      result += c;
    else
      result += kEntities[at];
  }
  return result;
}

std::string shortened(std::string_view lines) {
  std::string result;
  for (;;) {
    const std::size_t end = lines.find('\n');
    result += without_middle(lines.substr(0, end));
    if (end == std::string_view::npos) return result;
    result += '\n';
    lines.remove_prefix(end + 1);
  }
}

}  // namespace gurney
