#include "groundmotions/assembly/file_name_direction.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "engine/base/units.h"
#include "groundmotions/formats/header_text.h"
#include "groundmotions/formats/numbers.h"
#include "groundmotions/formats/words.h"

namespace gurney::groundmotions {

namespace {

bool says_nothing(const Component& component) {
  return !component.azimuth && !component.direction &&
         (component.name.empty() || component.name.starts_with("column ") ||
          upper(component.name) == "A" || quantity_in(component.name) == "acceleration");
}

bool needs_direction(const UnplacedComponent& component) {
  return !component.stated && says_nothing(component.component);
}

bool at_right_angle(const std::vector<UnplacedComponent>& components) {
  std::vector<double> azimuths;
  std::size_t verticals = 0;
  for (const UnplacedComponent& each : components) {
    verticals += each.component.direction == Direction::kVertical;
    if (each.component.azimuth) azimuths.push_back(*each.component.azimuth);
  }
  return verticals < 2 && azimuths.size() == 2 &&
         std::abs(std::abs(std::remainder(azimuths[0] - azimuths[1], std::numbers::pi)) -
                  std::numbers::pi / 2) < kRadiansPerDegree;
}

}  // namespace

bool orient_by_file_name(Component& component) {
  constexpr std::array<std::string_view, 5> kUp = {"UP", "VER", "VERT", "-V", "_V"};
  if (!says_nothing(component)) return false;
  const std::string stem = upper(std::filesystem::path(component.file).stem().string());
  const std::string digits = stem.size() > 3 ? stem.substr(stem.size() - 3) : "";
  const auto azimuth =
      digits.find_first_not_of("0123456789") == digits.npos ? number(digits) : std::nullopt;
  if (azimuth && *azimuth <= 360)
    component.azimuth = std::fmod(*azimuth, 360) * kRadiansPerDegree;
  else if (std::ranges::any_of(kUp, [&](auto up) { return stem.ends_with(up); }))
    component.direction = Direction::kVertical;
  else
    return false;
  component.warnings.push_back(fmt::format("its direction ({}) was taken from the file's name",
                                           component.azimuth ? digits : "up"));
  return true;
}

void orient_by_file_names(std::vector<UnplacedComponent>& components) {
  std::vector<UnplacedComponent> oriented = components;
  for (UnplacedComponent& each : oriented)
    if (needs_direction(each) && !orient_by_file_name(each.component)) return;
  if (std::ranges::any_of(components, needs_direction) && at_right_angle(oriented))
    components = std::move(oriented);
}

}  // namespace gurney::groundmotions
