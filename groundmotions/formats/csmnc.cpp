#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "groundmotions/formats/header_text.h"
#include "groundmotions/formats/numbers.h"
#include "groundmotions/formats/orientation.h"
#include "groundmotions/formats/readers.h"
#include "groundmotions/formats/source_file.h"
#include "groundmotions/formats/stated.h"
#include "groundmotions/formats/words.h"

namespace gurney::groundmotions {

namespace {

constexpr std::size_t kHeaderLines = 30;  ///< a header ends within these; files have 15
constexpr std::string_view kUnit = "UNIT", kCount = "NO. OF POINTS", kPeak = "PEAK VALUE",
                           kDuration = "DURATION";
constexpr std::array<std::string_view, 2> kComponents = {"COMPONENT", "COMP"};
constexpr std::array<std::string_view, 2> kSteps = {"EQUALLY SPACED INTERVALS OF",
                                                    "EQUALLY SPACED INTERVAL OF"};

/// A line of the header and where a key ends in it.
struct Place {
  std::size_t line = 0;  ///< from 0
  std::size_t end = kNone;
};

std::optional<Place> find(const SourceFile& file, std::string_view key) {
  for (std::size_t i = 0; i < std::min(kHeaderLines, file.lines().size()); ++i)
    if (const auto at = upper(file.lines()[i].substr(0, 400)).find(key); at != kNone)
      return Place{i, at + key.size()};
  return {};
}

std::optional<Place> find(const SourceFile& file, const std::array<std::string_view, 2>& keys) {
  const auto place = find(file, keys[0]);
  return place ? place : find(file, keys[1]);
}

/// The text behind a key, its colon and blanks apart.
std::string_view behind(const SourceFile& file, const Place& place) {
  const auto line = file.lines()[place.line];
  const auto rest = line.substr(std::min(place.end, line.size()));
  return trimmed(rest.substr(std::min(rest.find_first_not_of(" \t:."), rest.size())));
}

std::string_view word_behind(const SourceFile& file, const Place& place) {
  const auto text = behind(file, place);
  return text.substr(0, text.find_first_of(" \t"));
}

double number_behind(const SourceFile& file, const Place& place, std::string_view key,
                     FileErrors& errors) {
  auto text = behind(file, place);
  const auto value = take_number(text);
  if (!value)
    errors.add(place.line + 1, 1,
               fmt::format("{} must be a number, got '{}'", key, text.substr(0, 40)));
  return value.value_or(0);
}

/// The first line after the header: numbers only.
std::size_t first_sample_line(const SourceFile& file, std::size_t line) {
  const auto is_number = [](std::string_view word) {
    return take_number(word) && (word.empty() || word[0] == '-');
  };
  for (; line < file.lines().size(); ++line) {
    const auto words = words_of(file.lines()[line], " \t\r");
    if (!words.empty() && std::ranges::all_of(words, is_number)) break;
  }
  return line;
}

void refuse_other_quantities(const SourceFile& file, const Place& unit, FileErrors& errors) {
  const auto line = trimmed(file.lines()[unit.line]);
  const auto quantity = quantity_in(line);
  const auto other = other_quantity(word_behind(file, unit));
  if (!other && (!quantity || quantity == "acceleration")) return;
  errors.add(unit.line + 1, 1,
             fmt::format("a record must be acceleration, but this is a {} file ('{}'); take the "
                         "acceleration file of this component",
                         other ? *other : *quantity, line));
  errors.throw_if_any();
}

/// Lines in front of the component: earthquake, station and their facts.
void set_facts(const SourceFile& file, std::size_t end, Component& component) {
  for (std::size_t i = 0; i < std::min(end, file.lines().size()); ++i) {
    const auto line = trimmed(file.lines()[i]);
    const std::string text = upper(line);
    if (text.starts_with("STATION:"))
      component.header.emplace_back("station", trimmed(line.substr(8)));
    else if (text.find("EARTHQUAKE") != std::string::npos)
      component.header.emplace_back("event", line);
    else if (!line.empty() && i > 0)
      component.header.emplace_back(fmt::format("text {}", i + 1), line);
  }
}

void check_against_header(const SourceFile& file, const AccelerationUnit& unit,
                          Component& component, FileErrors& errors) {
  if (const auto peak = find(file, kPeak))
    check_peak(word_behind(file, *peak), unit, peak->line + 1, component, errors);
  if (const auto length = find(file, kDuration))
    check_length(number_behind(file, *length, kDuration, errors), length->line + 1, component,
                 errors);
}

}  // namespace

bool recognises_csmnc(const SourceFile& file) {
  return find(file, kUnit) && find(file, kCount) && find(file, kSteps) && find(file, kComponents);
}

/// @throws Error for velocities and displacements, missing or wrong header lines, a count that does
///         not match, and a peak or a length far from that of the header.
std::vector<Component> read_csmnc(const SourceFile& file, const ReadOptions& options) {
  FileErrors errors(file);
  const Place unit_place = *find(file, kUnit), count = *find(file, kCount),
              step = *find(file, kSteps);
  refuse_other_quantities(file, unit_place, errors);

  Component component;
  const AccelerationUnit unit =
      checked_unit(word_behind(file, unit_place), unit_place.line + 1, options, errors);
  component.unit = unit.name;
  component.time_step = checked_time_step(number_behind(file, step, kSteps[0], errors), kSteps[0],
                                          step.line + 1, options, errors);
  const double points = number_behind(file, count, kCount, errors);
  NumberReader reader(file, errors);
  const std::size_t first = first_sample_line(file, std::max(count.line, step.line) + 1);
  read_to_end(file, first, reader);
  if (!errors.any()) check_count(points, kCount, count.line + 1, reader.values().size(), errors);
  errors.throw_if_any();

  component.acceleration = scaled(reader.values(), unit.to_si);
  component.name = word_behind(file, *find(file, kComponents));
  orient(component.name, component);
  set_facts(file, first, component);
  check_against_header(file, unit, component, errors);
  errors.throw_if_any();
  return {component};
}

}  // namespace gurney::groundmotions
