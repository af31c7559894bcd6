#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "groundmotions/formats/calendar.h"
#include "groundmotions/formats/numbers.h"
#include "groundmotions/formats/orientation.h"
#include "groundmotions/formats/readers.h"
#include "groundmotions/formats/source_file.h"
#include "groundmotions/formats/stated.h"
#include "groundmotions/formats/words.h"

namespace gurney::groundmotions {
namespace {

/// The lines `key: value` at the top of a file.
class ColonHeader {
 public:
  struct Entry {
    std::string_view key;
    std::string_view value;  ///< may be empty
    std::size_t line;        ///< from 1
  };

  /// Reads up to the first line without a colon.
  explicit ColonHeader(const SourceFile& file) {
    for (const std::string_view line : file.lines()) {
      const auto colon = line.find(':');
      if (colon == kNone) break;
      entries_.push_back(
          {trimmed(line.substr(0, colon)), trimmed(line.substr(colon + 1)), entries_.size() + 1});
    }
  }

  /// How many lines it has.
  std::size_t lines() const { return entries_.size(); }

  /// The entry `key`, or null.
  const Entry* find(std::string_view key) const {
    const auto at = std::ranges::find(entries_, key, &Entry::key);
    return at == entries_.end() ? nullptr : &*at;
  }

  /// The first entry whose key starts with `start`, or null.
  const Entry* find_start(std::string_view start) const {
    const auto at =
        std::ranges::find_if(entries_, [&](const Entry& e) { return e.key.starts_with(start); });
    return at == entries_.end() ? nullptr : &*at;
  }

  /// The value of `key`, empty if there is none.
  std::string_view value(std::string_view key) const {
    const Entry* entry = find(key);
    return entry ? entry->value : std::string_view();
  }

  /// The number of `key`; an error and 0 if it is no number or not there.
  double number_of(std::string_view key, FileErrors& errors) const {
    const Entry* entry = find(key);
    const auto value = entry ? number(entry->value) : std::nullopt;
    if (!entry)
      errors.add(fmt::format("the header has no line '{}'", key));
    else if (!value)
      errors.add(entry->line, 1, fmt::format("{} must be a number, got '{}'", key, entry->value));
    return value.value_or(0);
  }

 private:
  std::vector<Entry> entries_;
};

bool has(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

void refuse_other_quantities(const ColonHeader& header, FileErrors& errors) {
  const auto* type = header.find("DATA_TYPE");
  const auto* units = header.find("UNITS");
  for (const char* wrong : {"SPECTRUM", "VELOCITY", "DISPLACEMENT"})
    if (type && has(type->value, wrong)) {
      errors.add(type->line, 1,
                 fmt::format("a record must be acceleration, but DATA_TYPE is '{}'; take the "
                             "acceleration file of this component (.ACC.ASC)",
                             type->value));
      errors.throw_if_any();
    }
  if (const auto quantity = units ? other_quantity(units->value) : std::nullopt)
    errors.add(units->line, 1,
               fmt::format("a record must be acceleration, but UNITS are '{}': {}; take the "
                           "acceleration file of this component (.ACC.ASC)",
                           units->value, *quantity));
  errors.throw_if_any();
}

void set_start(const ColonHeader& header, Component& component) {
  const auto* sample = header.find("DATE_TIME_FIRST_SAMPLE_YYYYMMDD_HHMMSS");
  if (sample && !sample->value.empty()) {
    component.start_time = utc_seconds(sample->value);
    // AFAD writes the day first.
    if (!component.start_time) component.start_time = day_first_utc_seconds(sample->value);
    if (!component.start_time)
      component.warnings.push_back(
          fmt::format("the start of the record is not known: {} must be a date and a time, got "
                      "'{}'",
                      sample->key, sample->value));
    return;
  }
  // The old header has no date of the first sample: that of the event, unless midnight is between.
  constexpr double kHalfDay = 12 * 3600, kDay = 24 * 3600;
  const std::string date(header.value("EVENT_DATE_YYYYMMDD"));
  const auto first = utc_seconds(date + "_" + std::string(header.value("TIME_FIRST_SAMPLE_S")));
  const auto event = utc_seconds(date + "_" + std::string(header.value("EVENT_TIME_HHMMSS")));
  if (!first || !event) return;
  component.start_time = *first - *event > kHalfDay   ? *first - kDay
                         : *event - *first > kHalfDay ? *first + kDay
                                                      : *first;
}

void set_facts(const ColonHeader& header, Component& component) {
  constexpr std::array<std::pair<const char*, const char*>, 21> kFacts = {
      {{"event", "EVENT_NAME"},
       {"event id", "EVENT_ID"},
       {"event date", "EVENT_DATE_YYYYMMDD"},
       {"event time", "EVENT_TIME_HHMMSS"},
       {"magnitude Mw", "MAGNITUDE_W"},
       {"magnitude ML", "MAGNITUDE_L"},
       {"network", "NETWORK"},
       {"location", "LOCATION"},
       {"station", "STATION_CODE"},
       {"station name", "STATION_NAME"},
       {"site class (EC8)", "SITE_CLASSIFICATION_EC8"},
       {"vs30 [m/s]", "VS30_M/S"},
       {"epicentral distance [km]", "EPICENTRAL_DISTANCE_KM"},
       {"published peak [cm/s2]", "PGA_CM/S^2"},
       {"baseline", "BASELINE_CORRECTION"},
       {"filter", "FILTER_TYPE"},
       {"filter order", "FILTER_ORDER"},
       {"low cut [Hz]", "LOW_CUT_FREQUENCY_HZ"},
       {"high cut [Hz]", "HIGH_CUT_FREQUENCY_HZ"},
       {"data type", "DATA_TYPE"},
       {"licence", "DATA_LICENSE"}}};
  for (const auto& [name, key] : kFacts)
    if (const auto value = header.value(key); !value.empty())
      component.header.emplace_back(name, value);
}

/// The duration counts samples or steps and has three decimals.
bool check_duration(const ColonHeader& header, const Component& component, FileErrors& errors) {
  const auto* entry = header.find("DURATION_S");
  const auto stated = entry ? number(entry->value) : std::nullopt;
  if (!stated || !(*stated > 0)) return false;
  const double held = static_cast<double>(component.acceleration.size()) * component.time_step;
  if (!(std::abs(held - *stated) <= 1.5 * component.time_step + 0.001 * held))
    errors.add(entry->line, 1,
               fmt::format("DURATION_S is {}, but {} samples at SAMPLING_INTERVAL_S {} have "
                           "{:.6g} s",
                           entry->value, component.acceleration.size(), component.time_step, held));
  return true;
}

/// Without a duration the time of the peak is the only check of the time step.
void check_time_of_peak(const ColonHeader& header, bool step_is_sure, Component& component,
                        FileErrors& errors) {
  const auto* entry = header.find("TIME_PGA_S");
  const auto time = entry ? number(entry->value) : std::nullopt;
  if (!time) return;
  Eigen::Index at = 0;
  const double largest = component.acceleration.cwiseAbs().maxCoeff(&at);
  const double step = component.time_step;
  // Equal peaks may be at several times; samples may be counted from 0 or 1.
  for (Eigen::Index i = 0; i < component.acceleration.size(); ++i)
    if (std::abs(static_cast<double>(i) * step - *time) <= 1.01 * step &&
        std::abs(component.acceleration[i]) >= 0.999 * largest)
      return;
  const std::string message = fmt::format(
      "the file states its peak at {} s, its samples have it "
      "at {:.9g} s",
      *time, static_cast<double>(at) * step);
  if (step_is_sure)
    component.warnings.push_back(message);
  else
    errors.add(entry->line, 1, message + ": SAMPLING_INTERVAL_S or TIME_PGA_S is wrong");
}

void check_against_header(const ColonHeader& header, Component& component, FileErrors& errors) {
  const bool step_is_sure = check_duration(header, component, errors);
  const auto* peak = header.find("PGA_CM/S^2");
  if (!peak || peak->value.empty()) return;
  check_peak(peak->value, {"cm/s2", 0.01}, peak->line, component, errors);
  check_time_of_peak(header, step_is_sure, component, errors);
}

void warn_of_state(const ColonHeader& header, Component& component) {
  if (has(header.value("BASELINE_CORRECTION"), "NOT REMOVED"))
    component.warnings.push_back("the header says BASELINE NOT REMOVED: this is a raw record");
  if (const auto depth = number(header.value("SENSOR_DEPTH_M")); depth && *depth > 0)
    component.warnings.push_back(fmt::format(
        "the sensor is {} m below the ground: this is not a motion of the surface", *depth));
}

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

bool recognises_esm(const SourceFile& file) {
  if (!file.lines().front().starts_with("EVENT_NAME:")) return false;
  const ColonHeader header(file);
  return header.find("NDATA") && header.find("SAMPLING_INTERVAL_S");
}

/// @throws Error for velocities, displacements and spectra, missing or wrong header lines, a count
///         that does not match, and a peak far from that of the header.
std::vector<Component> read_esm(const SourceFile& file, const ReadOptions& options) {
  FileErrors errors(file);
  const ColonHeader header(file);
  refuse_other_quantities(header, errors);

  Component component;
  component.time_step =
      checked_time_step(header.number_of("SAMPLING_INTERVAL_S", errors), "SAMPLING_INTERVAL_S",
                        header.find("SAMPLING_INTERVAL_S")->line, options, errors);
  const auto* units = header.find("UNITS");
  const AccelerationUnit unit = units && !units->value.empty()
                                    ? checked_unit(units->value, units->line, options, errors)
                                    : agreed_unit({}, 0, options, errors);
  component.unit = unit.name;
  const double count = header.number_of("NDATA", errors);

  NumberReader reader(file, errors);
  read_to_end(file, header.lines(), reader);
  if (!errors.any())
    check_count(count, "NDATA", header.find("NDATA")->line, reader.values().size(), errors);
  errors.throw_if_any();

  component.acceleration = scaled(reader.values(), unit.to_si);
  component.name = header.value(header.find("STREAM") ? "STREAM" : "COMPONENT");
  orient(component.name, component);
  set_facts(header, component);
  set_start(header, component);
  check_against_header(header, component, errors);
  warn_of_state(header, component);
  errors.throw_if_any();
  return {component};
}

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
