#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Words and numbers within the lines of a header.
namespace gurney::groundmotions {

std::string upper(std::string_view text);
std::string lower(std::string_view text);

/// The parts of `text` between any of the characters in `separators`; none is empty.
std::vector<std::string_view> words_of(std::string_view text, std::string_view separators);

/// The number behind `key` in `line`, blanks, '=' and ':' between them apart.
std::optional<double> number_after(std::string_view line, std::string_view key);

/// The text in the first () or [], blanks around it apart; empty if there is none.
std::string_view in_brackets(std::string_view text);

}  // namespace gurney::groundmotions
