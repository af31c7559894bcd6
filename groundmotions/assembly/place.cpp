#include "groundmotions/assembly/place.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/error.h"
#include "engine/base/units.h"
#include "groundmotions/formats/words.h"

namespace gurney::groundmotions {

namespace {

double degrees(double radians) { return radians / kRadiansPerDegree; }

/// Names of horizontals without an azimuth: H1, longitudinal, "a_g" and "x" of a table.
bool sounds_horizontal(std::string_view name) {
  const std::string plain = upper(name);
  return plain.starts_with("H1") || plain.starts_with("H2") || plain.starts_with("A") ||
         plain.starts_with("X") || plain.starts_with("L") || plain.starts_with("T");
}

std::optional<Component>& slot(Record& record, Direction direction) {
  return record.components[static_cast<std::size_t>(direction)];
}

void put(Component component, Direction direction, Record& record) {
  auto& place = slot(record, direction);
  require(!place, fmt::format("{}: a second {} component, after {}", component.file,
                              name_of(direction), place ? place->file : ""));
  component.direction = direction;
  place = std::move(component);
}

void put_stated(const UnplacedComponent& given, Record& record) {
  const Component& component = given.component;
  const Direction stated = *given.stated;
  require(
      !component.direction || *component.direction == stated,
      fmt::format("{}: given as {}, but its component {} is {}", component.file, name_of(stated),
                  component.name, name_of(component.direction.value_or(stated))));
  if (stated == Direction::kVertical ? component.azimuth.has_value()
                                     : sounds_vertical(component.name))
    record.warnings.push_back(
        fmt::format("{}: the file calls this component '{}', it is used as {}", component.file,
                    component.name, name_of(stated)));
  put(component, stated, record);
}

/// How far `to` lies counter-clockwise from `from`, in (-pi, pi].
double counter_clockwise(double from, double to) {
  return -std::remainder(to - from, 2 * std::numbers::pi);
}

/// Only a warning: the places were stated.
void warn_of_stated_azimuths(Record& record) {
  const auto& h1 = record[Direction::kH1];
  const auto& h2 = record[Direction::kH2];
  if (!h1 || !h2 || !h1->azimuth || !h2->azimuth) return;
  const double angle = counter_clockwise(*h1->azimuth, *h2->azimuth);
  constexpr double kRight = std::numbers::pi / 2, kTolerance = 1 * kRadiansPerDegree;
  const std::string azimuths =
      fmt::format("the horizontal components have azimuths of {:.0f} and {:.0f} degrees",
                  degrees(*h1->azimuth), degrees(*h2->azimuth));
  if (std::abs(std::abs(angle) - kRight) > kTolerance)
    record.warnings.push_back(azimuths + ", which is no right angle; they are used as if it were");
  else if (angle < 0)
    record.warnings.push_back(
        azimuths +
        " (clockwise from north), but h2 lies 90 degrees counter-clockwise from h1: the motion is "
        "a mirror image; exchange the two, or let the azimuths place them");
}

void put_horizontal_pair(Component first, Component second, Record& record) {
  if (first.azimuth && second.azimuth) {
    const double angle = counter_clockwise(*first.azimuth, *second.azimuth);
    if (angle < 0) std::swap(first, second);
  } else {
    record.warnings.push_back(
        fmt::format("{}: the directions of '{}' and '{}' are not known; they are taken as h1 and "
                    "h2, at a right angle, in this order",
                    first.file, first.name, second.name));
  }
  put(std::move(first), Direction::kH1, record);
  put(std::move(second), Direction::kH2, record);
}

/// A name that says no direction may be that of a vertical.
void put_only_horizontal(Component component, Record& record) {
  if (!component.azimuth && !component.name.empty() && !sounds_horizontal(component.name))
    record.warnings.push_back(
        fmt::format("{}: the direction of '{}' is not known; it is taken as h1", component.file,
                    component.name));
  put(std::move(component), Direction::kH1, record);
}

std::string listed(const std::vector<Component>& components) {
  std::string names;
  for (const Component& component : components)
    names += fmt::format("{}'{}'", names.empty() ? "" : ", ", component.name);
  return names;
}

void put_horizontals(std::vector<Component> horizontals, Record& record) {
  if (horizontals.empty()) return;
  const bool any_placed = record[Direction::kH1] || record[Direction::kH2];
  require(!any_placed, fmt::format("{}: the file does not say whether it is h1, h2 or vertical; "
                                   "state it",
                                   horizontals.front().file));
  require(horizontals.size() <= 2,
          fmt::format("{}: {} horizontal components ({}); a record has two: say which by "
                      "--columns (tables of plain text) or by `channels` in a list of records",
                      horizontals.front().file, horizontals.size(), listed(horizontals)));
  if (horizontals.size() == 2)
    put_horizontal_pair(std::move(horizontals[0]), std::move(horizontals[1]), record);
  else
    put_only_horizontal(std::move(horizontals[0]), record);
}

}  // namespace

bool sounds_vertical(std::string_view name) {
  const std::string plain = upper(name);
  static constexpr std::array kNames = {"UP",   "DWN", "DOWN",     "V",   "VER",
                                        "VERT", "VRT", "VERTICAL", "Z",   "UD",
                                        "U-D",  "UD1", "UD2",      "-UP", "+UP"};
  if (std::ranges::find(kNames, plain) != kNames.end()) return true;
  // SEED channels of accelerometers: band, instrument N or L or G, orientation Z
  return plain.size() == 3 && plain[2] == 'Z' && std::isalpha(static_cast<unsigned char>(plain[0]));
}

Record place(const std::vector<UnplacedComponent>& components) {
  Record record;
  std::vector<Component> horizontals;
  for (const UnplacedComponent& given : components) {
    const Component& component = given.component;
    if (given.stated)
      put_stated(given, record);
    else if (component.direction)
      put(component, *component.direction, record);
    else if (sounds_vertical(component.name))
      put(component, Direction::kVertical, record);
    else
      horizontals.push_back(component);
  }
  warn_of_stated_azimuths(record);
  put_horizontals(std::move(horizontals), record);
  return record;
}

}  // namespace gurney::groundmotions
