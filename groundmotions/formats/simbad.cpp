#include <fmt/format.h>

#include "groundmotions/formats/colon_header.h"
#include "groundmotions/formats/numbers.h"
#include "groundmotions/formats/orientation.h"
#include "groundmotions/formats/readers.h"
#include "groundmotions/formats/stated.h"
#include "groundmotions/formats/words.h"

namespace gurney::groundmotions {

namespace {

constexpr std::string_view kStep = "Time Increment (s)";
constexpr std::string_view kCount = "Number of Data";
constexpr std::string_view kSeries = "time series in ";

void check_published_peak(const ColonHeader& header, Component& component, FileErrors& errors) {
  const auto* peak = header.find_start("PGA");
  if (!peak) return;
  const auto unit = acceleration_unit(in_brackets(peak->key));
  if (!unit) {
    errors.add(peak->line, 1,
               fmt::format("'{}' is not a unit of acceleration: {} are allowed",
                           in_brackets(peak->key), kAccelerationUnits));
    return;
  }
  component.header.emplace_back("published peak", fmt::format("{} {}", peak->value, unit->name));
  check_peak(peak->value, *unit, peak->line, component, errors);
}

}  // namespace

bool recognises_simbad(const SourceFile& file) {
  const ColonHeader header(file);
  return header.find(kStep) && header.find(kCount);
}

/// @throws Error for velocities and displacements, missing or wrong header lines, a count that does
///         not match, and a peak far from that of the header.
std::vector<Component> read_simbad(const SourceFile& file, const ReadOptions& options) {
  FileErrors errors(file);
  const ColonHeader header(file);
  const std::size_t title = header.lines();
  const auto line = title < file.lines().size() ? file.lines()[title] : std::string_view();
  const auto series = line.find(kSeries);
  if (series == std::string_view::npos) {
    errors.add(title + 1, 1,
               "the header must end in a line such as 'Acceleration time series in m/s/s'");
    errors.throw_if_any();
  }
  const auto unit_text = trimmed(line.substr(series + kSeries.size()));
  if (const auto quantity = other_quantity(unit_text)) {
    errors.add(title + 1, 1,
               fmt::format("a record must be acceleration, but this is a {} file ('{}'); take "
                           "the .cor.acc file of this component",
                           *quantity, trimmed(line)));
    errors.throw_if_any();
  }

  Component component;
  const AccelerationUnit unit = checked_unit(unit_text, title + 1, options, errors);
  component.unit = unit.name;
  component.time_step = checked_time_step(header.number_of(kStep, errors), kStep,
                                          header.find(kStep)->line, options, errors);
  const double count = header.number_of(kCount, errors);
  NumberReader reader(file, errors);
  read_to_end(file, title + 1, reader);
  if (!errors.any())
    check_count(count, kCount, header.find(kCount)->line, reader.values().size(), errors);
  errors.throw_if_any();

  component.acceleration = scaled(reader.values(), unit.to_si);
  component.name = header.value("Orientation");
  orient(component.name, component);
  const std::pair<const char*, const char*> facts[] = {
      {"event time", "Event Date & Time"},
      {"station", "Station Code / Name"},
      {"network", "Network"},
      {"processing", "Processing Info"},
      {"filter corners [Hz]", "Filter Cut-off Frequency (Hz)"}};
  for (const auto& [name, key] : facts)
    if (const auto value = header.value(key); !value.empty())
      component.header.emplace_back(name, value);
  check_published_peak(header, component, errors);
  errors.throw_if_any();
  return {component};
}

}  // namespace gurney::groundmotions
