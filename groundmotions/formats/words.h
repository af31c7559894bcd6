#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "groundmotions/record/acceleration_unit.h"

/// Words and numbers within the lines of a header.
namespace gurney::groundmotions {

inline constexpr auto kNone = std::string_view::npos;

/// Letters and digits of ASCII.
inline bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
inline bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_blank(std::string_view line);

/// Whether `word` is one of those in `list`, which blanks part; whether it begins with one.
bool is_one_of(std::string_view word, std::string_view list);
bool begins_with_one_of(std::string_view word, std::string_view list);

/// `text` without any of `characters` at its start.
std::string_view left_trimmed(std::string_view text, std::string_view characters);

/// Where `word` stands alone in `line`; digits may touch it: `NPTS=2000DT=.02`.
std::size_t find_word(std::string_view line, std::string_view word);

std::string upper(std::string_view text);
std::string lower(std::string_view text);

/// The parts of `text` between any of the characters in `separators`; none is empty.
std::vector<std::string_view> words_of(std::string_view text, std::string_view separators);

/// The number behind `key` in `line`, blanks, '=' and ':' between them apart.
std::optional<double> number_after(std::string_view line, std::string_view key);

/// The text in the first () or [], blanks around it apart; empty if there is none.
std::string_view in_brackets(std::string_view text);

/// The unit of acceleration that a header line names somewhere, letter case apart: "UNITS: G)",
/// "SEC AND G/10.", "in cm/sec2.". A tenth of g is "g/10".
std::optional<AccelerationUnit> unit_in(std::string_view line);

/// Seconds in a unit of time: s, sec, seconds, ms, msec, milliseconds, us, min, minutes; nothing
/// for any other.
std::optional<double> time_unit(std::string_view spelling);

/// A factor right behind a unit: "x 10" of ") x 10", "/1000", "* 1e3"; empty if there is none.
std::string_view factor_behind(std::string_view unit_end);

/// "velocity" or "displacement" if that is what the unit measures, else nothing.
std::optional<std::string_view> other_quantity(std::string_view unit);

}  // namespace gurney::groundmotions
