#include "groundmotions/formats/words.h"

#include <algorithm>
#include <cctype>
#include <string>

#include "groundmotions/formats/numbers.h"

namespace gurney::groundmotions {

bool is_blank(std::string_view line) { return trimmed(line).empty(); }

bool is_one_of(std::string_view word, std::string_view list) {
  const auto words = words_of(list, " ");
  return std::ranges::find(words, word) != words.end();
}

bool begins_with_one_of(std::string_view word, std::string_view list) {
  return std::ranges::any_of(words_of(list, " "),
                             [&](std::string_view start) { return word.starts_with(start); });
}

std::string_view left_trimmed(std::string_view text, std::string_view characters) {
  return text.substr(std::min(text.find_first_not_of(characters), text.size()));
}

std::size_t find_word(std::string_view line, std::string_view word) {
  for (auto at = line.find(word); at != kNone; at = line.find(word, at + 1)) {
    const auto end = at + word.size();
    if ((at == 0 || !is_letter(line[at - 1])) && (end == line.size() || !is_letter(line[end])))
      return at;
  }
  return kNone;
}

std::string upper(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return result;
}

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

std::vector<std::string_view> words_of(std::string_view text, std::string_view separators) {
  std::vector<std::string_view> words;
  for (auto begin = text.find_first_not_of(separators); begin != kNone;) {
    const auto end = std::min(text.find_first_of(separators, begin), text.size());
    words.push_back(text.substr(begin, end - begin));
    begin = text.find_first_not_of(separators, end);
  }
  return words;
}

std::optional<double> number_after(std::string_view line, std::string_view key) {
  const auto at = line.find(key);
  if (at == kNone) return {};
  auto rest = left_trimmed(line.substr(at + key.size()), " \t=:");
  return take_number(rest);
}

std::string_view in_brackets(std::string_view text) {
  const auto open = text.find_first_of("([");
  if (open == kNone) return {};
  text.remove_prefix(open + 1);
  return trimmed(text.substr(0, text.find_first_of(")]")));
}

std::optional<AccelerationUnit> unit_in(std::string_view line) {
  for (const std::string_view word : words_of(line, " \t(),:;=[]"))
    if (const auto unit = acceleration_unit(word)) return unit;
  return {};
}

std::optional<double> time_unit(std::string_view spelling) {
  const std::string text = plain_unit(spelling);
  if (text == "s") return 1;
  // "seconds" is "s" in the plain spelling, so "milliseconds" is "millis".
  if (is_one_of(text, "ms millis")) return 1e-3;
  if (is_one_of(text, "us micros \xc2\xb5s \xce\xbcs")) return 1e-6;
  if (is_one_of(text, "min minute minutes")) return 60;
  return {};
}

std::string_view factor_behind(std::string_view unit_end) {
  constexpr std::string_view kCross = "\xc3\x97";  // U+00D7
  unit_end = left_trimmed(unit_end, " \t)]}.");
  if (unit_end.empty()) return {};
  std::string_view rest = unit_end;
  if (rest.starts_with(kCross))
    rest.remove_prefix(kCross.size());
  else if (std::string_view("xX*/").find(rest[0]) != std::string_view::npos)
    rest.remove_prefix(1);
  else
    return {};
  rest = left_trimmed(rest, " \t(");
  if (!take_number(rest)) return {};
  return unit_end.substr(0, unit_end.size() - rest.size());
}

std::optional<std::string_view> other_quantity(std::string_view unit) {
  std::string text = plain_unit(unit);
  if (text == "kine") return "velocity";
  const bool is_rate = text.ends_with("/s");
  if (is_rate) text.resize(text.size() - 2);
  if (!is_one_of(text, "m cm mm in ft")) return {};
  return is_rate ? "velocity" : "displacement";
}

}  // namespace gurney::groundmotions
