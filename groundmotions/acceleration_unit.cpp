#include "groundmotions/acceleration_unit.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

#include "engine/base/units.h"

namespace gurney {

std::optional<AccelerationUnit> acceleration_unit(std::string_view spelling) {
  std::string text;
  for (const char c : spelling)
    text += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (text == "g") return AccelerationUnit{"g", kStandardGravity};
  if (text == "gal") return AccelerationUnit{"cm/s2", 0.01};

  constexpr std::array kPerSecondSquared = {"/s2", "/s/s", "/s^2", "/s**2", "/sec2", "/sec/sec"};
  constexpr std::array kLengths = {AccelerationUnit{"m/s2", 1}, AccelerationUnit{"cm/s2", 0.01},
                                   AccelerationUnit{"mm/s2", 0.001}};
  const auto slash = text.find('/');
  if (slash == std::string::npos) return {};
  if (std::ranges::find(kPerSecondSquared, text.substr(slash)) == kPerSecondSquared.end())
    return {};
  for (const AccelerationUnit& unit : kLengths)
    if (std::string_view(unit.name).substr(0, slash + 1) == text.substr(0, slash + 1)) return unit;
  return {};
}

}  // namespace gurney
