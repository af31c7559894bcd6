#include "engine/base/number_text.h"

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace gurney {

namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_sign(char c) { return c == '+' || c == '-'; }

/// The longest number at the start of `text`, and its end; nothing beyond the range of double, which
/// older versions of fast_float return as infinity or zero. libc++ reads no double by std::from_chars.
std::optional<double> leading_number(std::string_view text, const char*& end) {
  double value = 0;
  const auto read = fast_float::from_chars(text.data(), text.data() + text.size(), value);
  end = read.ptr;
  if (read.ec != std::errc() || !std::isfinite(value)) return {};
  if (value != 0) return value;
  const std::string_view taken = text.substr(0, static_cast<std::size_t>(end - text.data()));
  const std::string_view mantissa = taken.substr(0, taken.find_first_of("eE"));
  if (mantissa.find_first_of("123456789") != std::string_view::npos) return {};
  return value;
}

/// The number of a mantissa that ends before the D of its exponent, `-03` of `1.5D-03`; `rest`
/// begins with the D and is shortened. Nothing if there is no such exponent.
std::optional<double> with_d_exponent(std::string_view mantissa, std::string_view& rest) {
  if (rest.empty() || (rest[0] != 'D' && rest[0] != 'd')) return {};
  if (mantissa.find_first_of("eE") != std::string_view::npos) return {};
  std::size_t end = rest.size() > 1 && is_sign(rest[1]) ? 2 : 1;
  const std::size_t digits = end;
  while (end < rest.size() && is_digit(rest[end])) ++end;
  if (end == digits) return {};
  const std::string text = fmt::format("{}e{}", mantissa, rest.substr(1, end - 1));
  const char* stop = nullptr;
  const auto value = leading_number(text, stop);
  if (value) rest.remove_prefix(end);
  return value;
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  // Fields are short: a loop over their characters is faster than find_first_not_of().
  const auto is_blank = [](char c) {
    return std::ranges::find(kNumberBlanks, c) != kNumberBlanks.end();
  };
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::optional<double> take_number(std::string_view& text) {
  std::string_view digits = text;
  if (!digits.empty() && is_sign(digits[0])) digits.remove_prefix(1);
  // fast_float would take "inf", "nan" and a second minus.
  if (digits.empty() || !(is_digit(digits[0]) || digits[0] == '.')) return {};
  const char* end = nullptr;
  auto value = leading_number(digits, end);
  if (!value) return {};
  const bool negative = text[0] == '-';
  const auto length = static_cast<std::size_t>(end - digits.data());
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  value = with_d_exponent(digits.substr(0, length), text).value_or(*value);
  return negative ? -*value : *value;
}

std::optional<double> number(std::string_view text) {
  text = trimmed(text);
  const auto value = take_number(text);
  return text.empty() ? value : std::nullopt;
}

}  // namespace gurney
