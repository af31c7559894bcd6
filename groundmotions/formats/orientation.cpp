#include "groundmotions/formats/orientation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string>

#include "engine/base/units.h"
#include "groundmotions/formats/numbers.h"
#include "groundmotions/formats/words.h"

namespace gurney::groundmotions {

namespace {

/// Not the points of the compass NNE and ENE, which say neither north nor east.
bool is_seed_code(const std::string& code) {
  return code.size() == 3 && code != "NNE" && code != "ENE" &&
         std::ranges::all_of(code, [](unsigned char c) { return std::isalpha(c) != 0; }) &&
         (code[1] == 'N' || code[1] == 'G' || code[1] == 'L' || code[1] == 'H');
}

/// Azimuth in degrees of a bearing such as N08W or S45E.
std::optional<double> bearing(std::string_view word) {
  if (word.size() < 3 || word.size() > 6) return {};
  const char from = word.front(), towards = word.back();
  if ((from != 'N' && from != 'S') || (towards != 'E' && towards != 'W')) return {};
  const auto angle = number(word.substr(1, word.size() - 2));
  if (!angle || !(*angle >= 0 && *angle <= 90)) return {};
  const double start = from == 'N' ? 0 : 180;
  const double azimuth = (from == 'N') == (towards == 'E') ? start + *angle : start - *angle;
  return std::fmod(azimuth + 360, 360);
}

/// The number of a channel rather than of degrees.
bool is_lone_digit(std::string_view word) { return word.size() == 1 && word != "0"; }

std::optional<double> azimuth_in(std::string_view label) {
  const auto words = words_of(label, " \t,;:()");
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool has_unit = words[i].size() > 3 && words[i].ends_with("DEG");
    const auto degrees = number(words[i].substr(0, words[i].size() - (has_unit ? 3 : 0)));
    const bool named = has_unit || (words.size() == 1 && !is_lone_digit(words[0])) ||
                       (i + 1 < words.size() && words[i + 1].starts_with("DEG"));
    if (degrees && named && *degrees >= 0 && *degrees <= 360) return std::fmod(*degrees, 360);
    if (const auto result = bearing(words[i])) return result;
  }
  std::string glued(label);  // N 08 W
  std::erase(glued, ' ');
  if (const auto result = bearing(glued)) return result;
  constexpr std::string_view kPoints = "NESW";
  const auto point = label.size() == 1 ? kPoints.find(label[0]) : kNone;
  return point == kNone ? std::nullopt : std::optional(90.0 * static_cast<double>(point));
}

/// Directions that words and SEED codes name, letter case apart.
bool orient_by_word(std::string_view name, Component& component) {
  // English, Spanish, Portuguese, French, Italian, German and Turkish.
  constexpr std::string_view kNorth =
      "N NS N-S SN S-N NORTH NORTE NORTH-SOUTH NORTHSOUTH NORTE-SUR NORD KUZEY";
  constexpr std::string_view kEast =
      "E EW E-W WE W-E EO E-O O-E EAST ESTE EAST-WEST EASTWEST EST OST LESTE DOGU DO\xc4\x9fU";
  constexpr std::string_view kUp =
      "U UP UD U-D DU D-U V Z VER VERT VRT UPDO UP-DOWN UPDOWN VERTICAL VERTIKAL VERTICALE DUSEY "
      "D\xc3\xbc\xc5\x9f"
      "EY";

  std::string code = upper(trimmed(name));
  std::ranges::replace(code, '_', '-');
  if (code.ends_with('.')) code.pop_back();
  if (code.size() == 5 && number(code.substr(3))) code = code.substr(0, 3);  // with its location
  if (is_seed_code(code)) code = code.back();
  if (is_one_of(code, kNorth)) {
    component.azimuth = 0;
  } else if (is_one_of(code, kEast)) {
    component.azimuth = 90 * kRadiansPerDegree;
  } else if (is_one_of(code, kUp)) {
    component.direction = Direction::kVertical;
  } else if (is_one_of(code, "DN DWN DOWN")) {
    turn_up(trimmed(name), component);
  } else if (code == "SOUTH" || code == "WEST") {
    component.azimuth = (code == "SOUTH" ? 180 : 270) * kRadiansPerDegree;
  } else {
    return false;
  }
  return true;
}

/// The first word of "HNZ 00" or "BNZ.NC.--", if it is a code of an accelerometer.
bool orient_by_seed_code(std::string_view label, Component& component) {
  constexpr std::string_view kBands = "FGDCESHBML", kInstruments = "NGL", kDirections = "ENZ";
  const auto words = words_of(label, " \t,;:().-_");
  const auto code = words.empty() ? std::string_view() : words[0];
  const bool is_code = code.size() == 3 && is_seed_code(std::string(code)) &&
                       kBands.find(code[0]) != kNone && kInstruments.find(code[1]) != kNone &&
                       kDirections.find(code[2]) != kNone;
  return is_code && orient_by_word(code, component);
}

}  // namespace

void orient(std::string_view name, Component& component) {
  const std::string code = upper(trimmed(name));
  const auto degrees = number(code);
  if (degrees && *degrees >= 0 && *degrees <= 360) {
    if (!is_lone_digit(code)) component.azimuth = *degrees * kRadiansPerDegree;
  } else if (!orient_by_word(code, component)) {
    if (const auto azimuth = azimuth_in(code)) component.azimuth = *azimuth * kRadiansPerDegree;
  }
}

void name_and_orient(std::string_view name, Component& component) {
  component.name = name;
  orient(name, component);
}

bool says_direction(std::string_view name) {
  Component component;
  component.acceleration = Eigen::Vector2d::Zero();
  orient(name, component);
  return component.azimuth || component.direction;
}

bool orient_by_label(std::string_view text, Component& component) {
  const std::string label = upper(trimmed(text));
  if (const auto azimuth = azimuth_in(label)) {
    component.azimuth = *azimuth * kRadiansPerDegree;
    return true;
  }
  for (const std::string_view word : words_of(label, " \t,;:()=-")) {
    const bool alone = word == label;
    if (word == "UP" || word == "VERT" || word == "VERTICAL" || (alone && word == "V")) {
      component.direction = Direction::kVertical;
      return true;
    }
    if (word == "DOWN" || (alone && word == "DN")) {
      turn_up(word, component);
      return true;
    }
  }
  return orient_by_word(label, component) || orient_by_seed_code(label, component);
}

void turn_up(std::string_view why, Component& component) {
  component.direction = Direction::kVertical;
  component.acceleration = -component.acceleration;
  component.warnings.push_back(
      fmt::format("the component points down ({}): its sign was turned, up is positive", why));
}

}  // namespace gurney::groundmotions
