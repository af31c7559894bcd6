#include "groundmotions/formats/orientation.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

#include "engine/base/units.h"
#include "groundmotions/formats/numbers.h"

namespace gurney {

namespace {

template <std::size_t size>
bool is_one_of(std::string_view text, const std::array<std::string_view, size>& names) {
  return std::ranges::find(names, text) != names.end();
}

std::string upper(std::string_view text) {
  std::string result;
  for (const char c : trimmed(text))
    result += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return result;
}

bool is_seed_code(const std::string& code) {
  return code.size() == 3 &&
         std::ranges::all_of(code, [](unsigned char c) { return std::isalpha(c) != 0; }) &&
         (code[1] == 'N' || code[1] == 'G' || code[1] == 'L' || code[1] == 'H');
}

}  // namespace

void orient(std::string_view name, Component& component) {
  constexpr std::array<std::string_view, 5> kNorth = {"N", "NS", "N-S", "NORTH", "NORTH-SOUTH"};
  constexpr std::array<std::string_view, 6> kEast = {"E", "EW", "E-W", "WE", "EAST", "EAST-WEST"};
  constexpr std::array<std::string_view, 10> kUp = {"U", "UP",  "UD",   "U-D",      "V",
                                                    "Z", "VER", "VERT", "VERTICAL", "UP-DOWN"};
  constexpr std::array<std::string_view, 3> kDown = {"DN", "DWN", "DOWN"};

  std::string code = upper(name);
  if (code.size() == 5 && number(code.substr(3))) code = code.substr(0, 3);  // with its location
  if (is_seed_code(code)) code = code.back();
  const auto degrees = number(code);
  if (degrees && *degrees >= 0 && *degrees <= 360) {
    component.azimuth = *degrees * kRadiansPerDegree;
  } else if (is_one_of(code, kNorth)) {
    component.azimuth = 0;
  } else if (is_one_of(code, kEast)) {
    component.azimuth = 90 * kRadiansPerDegree;
  } else if (is_one_of(code, kUp)) {
    component.direction = Direction::kVertical;
  } else if (is_one_of(code, kDown)) {
    component.direction = Direction::kVertical;
    component.acceleration = -component.acceleration;
    component.warnings.push_back(
        fmt::format("component '{}' points down; its samples change sign so that they point up",
                    trimmed(name)));
  }
}

}  // namespace gurney
