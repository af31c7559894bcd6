#include "groundmotions/assembly/file_name_direction.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "groundmotions/formats/header_text.h"
#include "groundmotions/formats/orientation.h"
#include "groundmotions/formats/words.h"

namespace gurney::groundmotions {

namespace {

std::filesystem::path file_name(const Component& component) {
  return std::filesystem::path(component.file).filename();
}

void take(const NameMark& mark, Component& component) {
  component.name = mark.text;
  component.azimuth = mark.azimuth;
  if (!mark.azimuth) component.direction = mark.place;
  component.warnings.push_back(
      fmt::format("its direction ({}) was taken from the file's name", mark.text));
  if (mark.points_down) turn_up(mark.text, component);
}

/// The user's word counts; the name is a reason to look again.
void warn_of_stated_vertical(UnplacedComponent& each) {
  if (!each.stated || *each.stated == Direction::kVertical) return;
  if (const auto mark = vertical_mark(file_name(each.component)))
    each.component.warnings.push_back(
        fmt::format("{}: the file's name says '{}', a vertical; it is used as {}",
                    each.component.file, mark->text, name_of(*each.stated)));
}

}  // namespace

bool lacks_direction(const Component& component) {
  return !component.azimuth && !component.direction &&
         (component.name.empty() || component.name.starts_with("column ") ||
          upper(component.name) == "A" || quantity_in(component.name) == "acceleration");
}

void orient_by_file_names(std::vector<UnplacedComponent>& components) {
  std::vector<NamedFile> files;
  std::vector<UnplacedComponent*> unknown;
  for (UnplacedComponent& each : components) {
    const auto of_one_file = std::ranges::count_if(
        components, [&](const auto& other) { return other.component.file == each.component.file; });
    if (of_one_file > 1 || !lacks_direction(each.component)) continue;
    warn_of_stated_vertical(each);
    if (each.stated) continue;
    files.push_back({.path = file_name(each.component)});
    unknown.push_back(&each);
  }
  const NameMatches matches = match_names(files);
  for (std::size_t i = 0; i < unknown.size(); ++i)
    if (matches.marks[i]) take(*matches.marks[i], unknown[i]->component);
}

}  // namespace gurney::groundmotions
