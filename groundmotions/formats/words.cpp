#include "groundmotions/formats/words.h"

#include <algorithm>
#include <cctype>

#include "groundmotions/formats/numbers.h"

namespace gurney::groundmotions {

bool is_blank(std::string_view line) { return trimmed(line).empty(); }

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
  auto rest = line.substr(at + key.size());
  rest.remove_prefix(std::min(rest.find_first_not_of(" \t=:"), rest.size()));
  return take_number(rest);
}

std::string_view in_brackets(std::string_view text) {
  const auto open = text.find_first_of("([");
  if (open == kNone) return {};
  text.remove_prefix(open + 1);
  return trimmed(text.substr(0, text.find_first_of(")]")));
}

}  // namespace gurney::groundmotions
