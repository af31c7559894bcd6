#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/units.h"
#include "groundmotions/formats/header_text.h"
#include "groundmotions/formats/numbers.h"
#include "groundmotions/formats/orientation.h"
#include "groundmotions/formats/plain_rows.h"
#include "groundmotions/formats/readers.h"
#include "groundmotions/formats/source_file.h"
#include "groundmotions/formats/stated.h"
#include "groundmotions/formats/time_column.h"
#include "groundmotions/formats/words.h"
#include "groundmotions/formats/writers.h"
#include "groundmotions/record/acceleration_unit.h"

namespace gurney::groundmotions {

namespace {

constexpr std::size_t kHeaderLines = 20;  ///< a header ends within these

/// A number of the header and the line that has it (from 0).
struct Entry {
  std::optional<double> value;
  std::size_t line = kNone;
};

/// NPTS and DT, as `KEY= value` or as `value value NPTS, DT`.
struct Header {
  Entry samples, time_step;
  std::size_t quantity_line = kNone;
  std::string quantity;  ///< "ACCELERATION", "VELOCITY", "DISPLACEMENT" or empty
  std::size_t unit_line = kNone;
  std::string unit;
  bool has_unit_word = false;

  std::size_t first_data_line() const {
    std::size_t first = 0;
    for (const auto line : {samples.line, time_step.line, quantity_line, unit_line})
      if (line != kNone) first = std::max(first, line + 1);
    return first;
  }
};

void find_entry(std::string_view line, std::string_view key, std::size_t index, Entry& entry) {
  const auto at = find_word(line, key);
  if (at == kNone || entry.value) return;
  auto rest = left_trimmed(line.substr(at + key.size()), " \t=:");
  const auto value = key == "DT" ? leading_time(rest) : take_number(rest);
  if (value) entry = {value, index};
}

void find_leading_pair(std::string_view line, std::size_t index, Header& header) {
  const auto key = find_word(line, "NPTS");
  if (key == kNone || find_word(line, "DT") == kNone) return;
  auto rest = trimmed(line.substr(0, key));
  const auto samples = take_number(rest);
  const auto time_step = number(rest);
  if (!samples || !time_step) return;
  header.samples = {samples, index};
  header.time_step = {time_step, index};
}

void find_quantity(std::string_view line, std::size_t index, Header& header) {
  for (const char* quantity : {"ACCELERATION", "VELOCITY", "DISPLACEMENT"}) {
    const auto at = line.find(quantity);
    if (at == kNone || !header.quantity.empty()) continue;
    const auto rest = trimmed(line.substr(at + std::string_view(quantity).size()));
    if (!rest.starts_with("TIME SERIES") && !rest.starts_with("TIME HISTORY")) continue;
    header.quantity = quantity;
    header.quantity_line = index;
  }
  const auto unit = unit_text_in(line);
  const bool is_statement = find_word(line, "UNITS") != kNone || quantity_in(line);
  if (!unit || !is_statement || !header.unit.empty()) return;
  header.unit = *unit;
  header.unit_line = index;
  header.has_unit_word = find_word(line, "UNITS") != kNone;
}

Header header_of(const SourceFile& file) {
  Header header;
  for (std::size_t i = 0; i < std::min(kHeaderLines, file.lines().size()); ++i) {
    const std::string line = upper(file.lines()[i].substr(0, 1000));
    find_quantity(line, i, header);
    find_leading_pair(line, i, header);
    find_entry(line, "NPTS", i, header.samples);
    find_entry(line, "DT", i, header.time_step);
  }
  return header;
}

/// The last field of a line, without a remark in brackets: "228" of "..., RRS, 228 (CDMG 24)".
std::string_view last_field(std::string_view line) {
  const auto comma = line.rfind(',');
  if (comma == kNone) return {};
  const auto field = line.substr(comma + 1);
  return trimmed(field.substr(0, field.find('(')));
}

/// Short, as "228", "N 08 W", "BHZ00" are, not words of a sentence.
bool is_component_name(std::string_view field) {
  constexpr std::size_t kLongest = 10;
  return !field.empty() && field.size() <= kLongest && words_of(field, " ").size() <= 3;
}

/// "1/17/1994" or "10/28/83".
bool has_date(std::string_view line) {
  return std::ranges::any_of(words_of(line, ", \t"), [](std::string_view word) {
    const auto parts = words_of(word, "/");
    return parts.size() == 3 &&
           std::ranges::all_of(parts, [](auto part) { return number(part).has_value(); });
  });
}

/// The line that names event, station and component: a date, and a direction as its last field.
std::optional<std::string_view> dated_line(const SourceFile& file, const Header& header) {
  for (std::size_t i = 0; i < std::min(header.first_data_line(), file.lines().size()); ++i) {
    const auto line = trimmed(file.lines()[i]);
    const auto field = last_field(line);
    if (is_component_name(field) && says_direction(field) && has_date(line)) return line;
  }
  return {};
}

/// The dated line, or else the second, or where that is blank the last above NPTS, quantity and unit.
std::string_view event_line(const SourceFile& file, const Header& header) {
  if (const auto line = dated_line(file, header)) return *line;
  std::size_t end = file.lines().size();
  for (const auto line :
       {header.samples.line, header.time_step.line, header.quantity_line, header.unit_line})
    end = std::min(end, line);
  if (end > 1 && end < file.lines().size() && !trimmed(file.lines()[1]).empty())
    return trimmed(file.lines()[1]);
  while (end > 0 && end < file.lines().size() && trimmed(file.lines()[end - 1]).empty()) --end;
  return end > 0 && end < file.lines().size() ? trimmed(file.lines()[end - 1]) : "";
}

/// The line of rotated records that names their component, `FN component, azimuth =   310.0`: the
/// directions in the lines above it are those before the rotation.
bool name_rotated(const SourceFile& file, const Header& header, Component& component) {
  constexpr std::string_view kWord = "COMPONENT", kAzimuth = "AZIMUTH";
  for (std::size_t i = 0; i < std::min(header.first_data_line(), file.lines().size()); ++i) {
    const std::string line = upper(file.lines()[i].substr(0, 1000));
    const auto word = find_word(line, kWord), azimuth = find_word(line, kAzimuth);
    if (word == kNone || azimuth == kNone || azimuth < word) continue;
    const auto degrees = number_after(std::string_view(line).substr(azimuth), kAzimuth);
    if (!degrees || !(*degrees >= 0 && *degrees <= 360)) continue;
    component.name = trimmed(file.lines()[i].substr(0, word));
    component.azimuth = std::fmod(*degrees, 360) * kRadiansPerDegree;
    return true;
  }
  return false;
}

/// The last field of that line names the component: "228", "360 (CDMG STATION 24461)", "UP".
void name_component(const SourceFile& file, const Header& header, Component& component) {
  const std::string_view event = event_line(file, header);
  if (!event.empty()) component.header.emplace_back("event", event);
  const auto field = last_field(event);
  if (name_rotated(file, header, component)) return;
  if (is_component_name(field)) {
    name_and_orient(field, component);
    return;
  }
  const std::size_t end = std::min(header.first_data_line(), file.lines().size());
  for (std::size_t i = 0; i < end && component.name.empty(); ++i)
    component.name = component_in(file.lines()[i].substr(0, 1000));
  orient(component.name, component);
}

/// The lines above the samples speak of a velocity or a displacement.
void refuse_other_quantities(const Header& header, LayoutReader& in) {
  const auto& lines = in.file.lines();
  const std::size_t end = std::min(header.first_data_line(), lines.size());
  const auto other = other_quantity_in({lines.begin(), lines.begin() + static_cast<long>(end)});
  if (other)
    in.refuse(other->line + 1,
              fmt::format("a record must be acceleration, but this is a {} file ('{}'); "
                          "take the .AT2 file of this component",
                          other->quantity, trimmed(lines[other->line])));
}

/// `2000 0.0200` alone on the line after the header.
void find_bare_pair(const SourceFile& file, Header& header) {
  const std::size_t line = header.first_data_line();
  if (header.samples.value || header.time_step.value || line >= file.lines().size()) return;
  auto rest = trimmed(file.lines()[line]);
  const auto samples = take_number(rest);
  const auto time_step = number(rest);
  if (!samples || !time_step || !(*samples >= 2 && *samples == std::floor(*samples)) ||
      !(*time_step > 0 && *time_step <= 1))
    return;
  header.samples = {samples, line};
  header.time_step = {time_step, line};
}

/// The first numbers of the first rows below the header, if they grow as times do.
struct FirstColumn {
  std::vector<double> times;  ///< none: they do not grow
  std::size_t width = 0;      ///< numbers in a row

  bool has_step(double step) const {
    for (std::size_t i = 1; i < times.size(); ++i)
      if (!(std::abs(times[i] - times[i - 1] - step) <= kTimeTolerance * step)) return false;
    return times.size() > 2 && width > 1;
  }
};

FirstColumn first_column(const SourceFile& file, const Header& header) {
  constexpr std::size_t kRows = 4;
  FirstColumn found;
  for (std::size_t line = header.first_data_line();
       line < file.lines().size() && found.times.size() < kRows; ++line) {
    if (is_text_line(file.lines()[line]) || trimmed(file.lines()[line]).empty()) continue;
    const auto words = words_of(file.lines()[line], " \t,;");
    const auto time = words.size() < 2 ? std::nullopt : number(words[0]);
    const bool grows = time && (found.times.empty() ||
                                (words.size() == found.width && *time > found.times.back()));
    if (!grows) return {};
    found.times.push_back(*time);
    found.width = words.size();
  }
  return found;
}

/// Rows of a time that grows and values: plain text, whatever the lines above them.
bool is_table(const SourceFile& file, const Header& header) {
  const FirstColumn column = first_column(file, header);
  if (column.times.size() < 3) return false;
  if (header.samples.value && header.time_step.value)
    return column.has_step(*header.time_step.value);
  return column.width == 2 || column.has_step(column.times[1] - column.times[0]);
}

}  // namespace

bool recognises_peer_at2(const SourceFile& file) {
  const Header header = header_of(file);
  if (header.samples.value && header.time_step.value) return !is_table(file, header);
  return !header.quantity.empty() && header.has_unit_word && !is_table(file, header);
}

/// @throws Error for a velocity or displacement file (VT2, DT2), an unknown unit, a missing time
///         step, text among the numbers, or a count that is not NPTS.
std::vector<Component> read_peer_at2(const SourceFile& file, const ReadOptions& options) {
  LayoutReader in(file, options);
  Header header = header_of(file);
  find_bare_pair(file, header);
  refuse_other_quantities(header, in);
  const Entry &samples = header.samples, &step = header.time_step;
  const double time_step = step.value ? in.checked_time_step({*step.value, "DT", step.line + 1})
                                      : in.agreed_time_step({}, 0);
  const AccelerationUnit unit = header.unit.empty()
                                    ? in.agreed_unit({}, 0)
                                    : in.checked_unit(header.unit, header.unit_line + 1);
  std::vector<std::string> warnings;
  std::size_t first = header.first_data_line();
  for (; first < file.lines().size() && is_text_line(file.lines()[first]); ++first)
    warnings.push_back(fmt::format("a line of text after the header, skipped: '{}'",
                                   trimmed(file.lines()[first]).substr(0, 60)));
  NumberReader reader(file, in.errors);
  read_to_end(file, first, reader);
  const std::size_t count = reader.values().size();
  if (!samples.value)
    warnings.push_back(fmt::format("the header states no NPTS: all {} numbers were taken", count));
  if (!in.errors.any() && samples.value)
    in.check_count({*samples.value, "NPTS", samples.line + 1}, count);
  else if (!in.errors.any())
    in.check_enough(static_cast<double>(count), 0);
  if (const auto error = axis_error(reader.values()); !error.empty()) in.error(first + 1, error);
  in.errors.throw_if_any();

  Component component = component_of(reader.values(), unit, time_step);
  component.warnings = warnings;
  component.header.emplace_back("title", trimmed(file.lines()[0]));
  name_component(file, header, component);
  if (header.quantity_line != kNone)
    component.header.emplace_back("quantity", trimmed(file.lines()[header.quantity_line]));
  if (samples.line != kNone)
    component.header.emplace_back("samples", trimmed(file.lines()[samples.line]));
  return {component};
}

std::string at2_text(const Component& component, const std::string& title,
                     const std::string& event) {
  std::string text = fmt::format(
      "{}\n{}, {}\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= {:6}, DT= {:.10g} SEC\n", title,
      event, component.name, component.acceleration.size(), component.time_step);
  for (Eigen::Index i = 0; i < component.acceleration.size(); ++i)
    text += fmt::format("{:16.7E}{}", component.acceleration[i] / kStandardGravity,
                        i % 5 == 4 ? "\n" : "");
  if (text.back() != '\n') text += "\n";
  return text;
}

}  // namespace gurney::groundmotions
