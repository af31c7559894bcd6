#include "groundmotions/formats/unit_text.h"

#include <algorithm>
#include <array>

#include "engine/base/units.h"
#include "groundmotions/formats/numbers.h"
#include "groundmotions/formats/words.h"

namespace gurney {

std::optional<AccelerationUnit> unit_in(std::string_view line) {
  const std::string text = upper(line);
  for (std::string_view word : words_of(text, " \t(),:;=")) {
    while (word.ends_with('.')) word.remove_suffix(1);
    if (word == "G/10") return AccelerationUnit{"g/10", kStandardGravity / 10};
    std::string spelling(word);
    for (auto at = spelling.find("SEC"); at != std::string::npos; at = spelling.find("SEC"))
      spelling.replace(at, 3, "S");
    if (spelling.starts_with("CMS/")) spelling.erase(2, 1);  // centimetres
    if (const auto unit = acceleration_unit(spelling)) return unit;
  }
  return {};
}

std::optional<std::string_view> other_quantity(std::string_view unit) {
  constexpr std::array kLengths = {"m", "cm", "mm", "in", "ft"};
  const std::string text = lower(trimmed(unit));
  if (std::ranges::find(kLengths, text) != kLengths.end()) return "displacement";
  for (const std::string_view second : {"/s", "/sec"})
    if (text.ends_with(second) &&
        std::ranges::find(kLengths, text.substr(0, text.size() - second.size())) != kLengths.end())
      return "velocity";
  return {};
}

}  // namespace gurney
