#include "groundmotions/record/acceleration_unit.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "engine/base/units.h"

namespace gurney::groundmotions {

namespace {

struct Spelling {
  std::string_view from, to;
};

/// In this order, on lower case.
constexpr std::array kSpellings = {
    Spelling{"\xc2\xb2", "2"},     Spelling{"\xb2", "2"},          // superscript, UTF-8 and Latin-1
    Spelling{"\xe2\x81\xbb", "-"}, Spelling{"\xe2\x88\x92", "-"},  // superscript minus, minus
    Spelling{"\xc2\xb7", ""},                                      // middle dot
    Spelling{"squared", "2"},      Spelling{"percent", "%"},      Spelling{"_per_", "/"},
    Spelling{"per", "/"},          Spelling{"seconds", "s"},      Spelling{"second", "s"},
    Spelling{"secs", "s"},         Spelling{"sec", "s"},          Spelling{"cms/", "cm/"},
    Spelling{"meters", "m"},       Spelling{"metres", "m"},       Spelling{"meter", "m"},
    Spelling{"metre", "m"},        Spelling{"centim", "cm"},      Spelling{"millim", "mm"},
    Spelling{"inches", "in"},      Spelling{"inch", "in"},        Spelling{"feet", "ft"},
    Spelling{"/sq.s", "/s2"},      Spelling{"%ofg", "%g"},        Spelling{"/s/s", "/s2"},
    Spelling{"/ss", "/s2"},        Spelling{"s-2", "/s2"},        Spelling{"s-1", "/s"},
    Spelling{"./", "/"},           Spelling{"//", "/"},           Spelling{"gals", "gal"},
    Spelling{"g's", "g"},          Spelling{"mps2", "m/s2"}};

std::string listed(const std::vector<std::string>& names) {
  std::string text = names[0];
  for (std::size_t i = 1; i < names.size(); ++i)
    text += (i + 1 < names.size() ? ", " : " or ") + names[i];
  return text;
}

bool is_dropped(char c) {
  return std::string_view(" \t^*()[]{}").find(c) != std::string_view::npos;
}

}  // namespace

const std::vector<std::string>& acceleration_unit_names() {
  static const std::vector<std::string> names = {"g",  "m/s2", "cm/s2", "gal",  "mm/s2",
                                                 "mg", "%g",   "ft/s2", "in/s2"};
  return names;
}

const std::string kAccelerationUnits = listed(acceleration_unit_names());

std::string plain_unit(std::string_view spelling) {
  std::string text;
  for (const char c : spelling)
    if (!is_dropped(c)) text += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const auto& [from, to] : kSpellings)
    for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
      text.replace(at, from.size(), to);
  while (text.ends_with('.')) text.pop_back();
  return text;
}

std::optional<AccelerationUnit> acceleration_unit(std::string_view spelling) {
  // The international foot is 0.3048 m, its inch 0.0254 m, exactly.
  constexpr std::array kUnits = {AccelerationUnit{"g", kStandardGravity},
                                 AccelerationUnit{"mg", kStandardGravity / 1000},
                                 AccelerationUnit{"%g", kStandardGravity / 100},
                                 AccelerationUnit{"g/10", kStandardGravity / 10},
                                 AccelerationUnit{"m/s2", 1},
                                 AccelerationUnit{"cm/s2", 0.01},
                                 AccelerationUnit{"mm/s2", 0.001},
                                 AccelerationUnit{"ft/s2", 0.3048},
                                 AccelerationUnit{"in/s2", 0.0254}};
  const std::string text = plain_unit(spelling);
  const std::string_view name = text == "gal" ? "cm/s2" : std::string_view(text);
  const auto at = std::ranges::find(kUnits, name, &AccelerationUnit::name);
  return at == kUnits.end() ? std::nullopt : std::optional(*at);
}

}  // namespace gurney::groundmotions
