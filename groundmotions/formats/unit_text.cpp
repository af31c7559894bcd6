#include "groundmotions/formats/unit_text.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "groundmotions/formats/numbers.h"
#include "groundmotions/formats/words.h"

namespace gurney::groundmotions {

std::optional<AccelerationUnit> unit_in(std::string_view line) {
  for (const std::string_view word : words_of(line, " \t(),:;=[]"))
    if (const auto unit = acceleration_unit(word)) return unit;
  return {};
}

std::optional<double> time_unit(std::string_view spelling) {
  // "seconds" is "s" in the plain spelling, so "milliseconds" is "millis".
  constexpr std::array<std::pair<std::string_view, double>, 10> kUnits = {{{"s", 1},
                                                                           {"ms", 1e-3},
                                                                           {"millis", 1e-3},
                                                                           {"us", 1e-6},
                                                                           {"micros", 1e-6},
                                                                           {"\xc2\xb5s", 1e-6},
                                                                           {"\xce\xbcs", 1e-6},
                                                                           {"min", 60},
                                                                           {"minute", 60},
                                                                           {"minutes", 60}}};
  const std::string text = plain_unit(spelling);
  for (const auto& [name, seconds] : kUnits)
    if (text == name) return seconds;
  return {};
}

std::string_view factor_behind(std::string_view unit_end) {
  constexpr std::string_view kCross = "\xc3\x97";  // U+00D7
  unit_end.remove_prefix(std::min(unit_end.find_first_not_of(" \t)]}."), unit_end.size()));
  if (unit_end.empty()) return {};
  std::string_view rest = unit_end;
  if (rest.starts_with(kCross))
    rest.remove_prefix(kCross.size());
  else if (std::string_view("xX*/").find(rest[0]) != std::string_view::npos)
    rest.remove_prefix(1);
  else
    return {};
  rest.remove_prefix(std::min(rest.find_first_not_of(" \t("), rest.size()));
  if (!take_number(rest)) return {};
  return unit_end.substr(0, unit_end.size() - rest.size());
}

std::optional<std::string_view> other_quantity(std::string_view unit) {
  constexpr std::array<std::string_view, 5> kLengths = {"m", "cm", "mm", "in", "ft"};
  std::string text = plain_unit(unit);
  if (text == "kine") return "velocity";
  const bool is_rate = text.ends_with("/s");
  if (is_rate) text.resize(text.size() - 2);
  if (std::ranges::find(kLengths, text) == kLengths.end()) return {};
  return is_rate ? "velocity" : "displacement";
}

}  // namespace gurney::groundmotions
