#include "groundmotions/formats/plain_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "groundmotions/formats/numbers.h"
#include "groundmotions/formats/orientation.h"
#include "groundmotions/formats/plain_columns.h"
#include "groundmotions/formats/plain_rows.h"
#include "groundmotions/formats/stated.h"
#include "groundmotions/formats/time_column.h"
#include "groundmotions/formats/unit_text.h"
#include "groundmotions/formats/words.h"

namespace gurney {

namespace {

/// Tables that look like records but are none; their other mistakes do not matter.
void refuse_spectra(const PlainRows& rows, const std::string& file) {
  Mistakes mistakes(file);
  for (const std::string_view line : rows.header) {
    const std::string text = lower(line);
    for (const char* word : {"psa", "rotd", "spectral", "spectrum", "spectra", "arias"})
      if (text.find(word) != std::string::npos) {
        mistakes.add(fmt::format(
            "a record must be an acceleration history, but the header speaks of '{}' ('{}')", word,
            line.substr(0, 80)));
        mistakes.throw_if_any();
      }
  }
}

/// A first row of a count and a time step, `4684 0.0100`, taken off the rows.
struct CountRow {
  double count = 0, time_step = 0;
  std::size_t line = 0;  ///< from 1; 0: there is none
};

CountRow take_count_row(PlainRows& rows) {
  if (rows.lengths.size() < 2 || rows.lengths[0] != 2) return {};
  const double count = rows.values[0], step = rows.values[1];
  if (!(count >= 2 && count == std::floor(count) && step > 0 && step <= 1)) return {};
  const bool fits = count == static_cast<double>(rows.values.size() - 2);
  if (!fits && rows.lengths[1] == 2) return {};
  const CountRow result{count, step, rows.lines[0]};
  rows.values.erase(rows.values.begin(), rows.values.begin() + 2);
  rows.lengths.erase(rows.lengths.begin());
  rows.lines.erase(rows.lines.begin());
  return result;
}

/// Unit of one column: stated by its title, by the user, or by both.
struct ColumnUnit {
  std::string name;
  double to_si = 1;
};

ColumnUnit unit_of(std::string_view title, std::size_t line, const ReadOptions& options,
                   Mistakes& mistakes) {
  const auto stated = in_brackets(title);
  const auto quantity = lower(title).starts_with("vel")    ? "velocity"
                        : lower(title).starts_with("disp") ? "displacement"
                                                           : other_quantity(stated).value_or("");
  if (!quantity.empty()) {
    mistakes.add(
        fmt::format("a record must be acceleration, but the column '{}' is a {}; name "
                    "the columns of accelerations, such as columns = \"time,h1,skip\"",
                    title, quantity));
    return {};
  }
  if (options.si_per_count) {
    if (acceleration_unit(stated))
      mistakes.add(
          line, 1,
          fmt::format("count_m_per_s2 is for raw counts, but the column '{}' has a unit", title));
    return {"counts", *options.si_per_count};
  }
  const AccelerationUnit unit = acceleration_unit(stated)
                                    ? checked_unit(stated, line, options, mistakes)
                                    : agreed_unit({}, 0, options, mistakes);
  return {unit.name, unit.to_si};
}

void set_header(const PlainRows& rows, Component& component) {
  constexpr std::size_t kShown = 20;
  for (std::size_t i = 0; i < std::min(kShown, rows.header.size()); ++i)
    component.header.emplace_back(fmt::format("text {}", i + 1), rows.header[i]);
}

void warn_of_text(const PlainRows& rows, Component& component) {
  std::size_t count = 0;
  for (const auto line : rows.header) count += line[0] != '#';
  if (count > 0)
    component.warnings.push_back(
        fmt::format("{} {} of text before the numbers, skipped; the last is '{}'", count,
                    count == 1 ? "line" : "lines", rows.header.back().substr(0, 60)));
  if (!rows.end.empty())
    component.warnings.push_back(
        fmt::format("{} {} after the numbers, skipped: '{}'", rows.end.size(),
                    rows.end.size() == 1 ? "line" : "lines", rows.end[0].substr(0, 60)));
}

double time_step_of(const CountRow& count, const ReadOptions& options, Mistakes& mistakes) {
  const auto stated = count.line > 0 ? std::optional(count.time_step) : std::nullopt;
  return agreed_time_step(stated, count.line, options, mistakes);
}

std::vector<double> column(const PlainRows& rows, std::size_t at, std::size_t width) {
  std::vector<double> values;
  for (std::size_t i = at; i < rows.values.size(); i += width) values.push_back(rows.values[i]);
  return values;
}

std::vector<Component> one_component(const PlainRows& rows, const CountRow& count,
                                     const ReadOptions& options, Mistakes& mistakes) {
  const auto titles = column_titles(rows, 1);
  const std::string title = titles.empty() || in_brackets(titles[0]).empty() ? "" : titles[0];
  const ColumnUnit unit = unit_of(title, rows.title_line, options, mistakes);
  Component component;
  component.time_step = time_step_of(count, options, mistakes);
  component.unit = unit.name;
  component.acceleration = scaled(rows.values, unit.to_si);
  return {component};
}

std::vector<Component> from_table(const PlainRows& rows, const PlainColumns& columns,
                                  const CountRow& count, const ReadOptions& options,
                                  Mistakes& mistakes) {
  using Kind = PlainColumns::Kind;
  const std::size_t width = columns.columns.size();
  const auto titles = column_titles(rows, width);
  const auto time = std::ranges::find(columns.columns, Kind::kTime, &PlainColumns::Column::kind);
  double step = 0, first = 0;
  if (time == columns.columns.end()) {
    step = time_step_of(count, options, mistakes);
  } else {
    const auto times =
        column(rows, static_cast<std::size_t>(time - columns.columns.begin()), width);
    const std::string title = titles.empty() ? "" : lower(titles[0]);
    if (title.starts_with("per") || title.starts_with("freq"))
      mistakes.add(
          rows.title_line, 1,
          fmt::format("a record must be a history, but the first column is '{}'", titles[0]));
    step = even_step(times, rows.lines, mistakes);
    first = times[0];
    if (!mistakes.any()) checked_time_step(step, "the time step", rows.lines[0], options, mistakes);
  }

  std::vector<Component> components;
  for (std::size_t k = 0; k < width; ++k) {
    if (columns.columns[k].kind != Kind::kComponent) continue;
    const std::string title = titles.empty() ? "" : titles[k];
    const ColumnUnit unit = unit_of(title, rows.title_line, options, mistakes);
    Component component;
    component.time_step = step;
    component.unit = unit.name;
    component.acceleration = scaled(column(rows, k, width), unit.to_si);
    component.name = trimmed(title.substr(0, title.find_first_of("([")));
    if (component.name.empty()) component.name = fmt::format("column {}", k + 1);
    component.direction = columns.columns[k].direction;
    if (!component.direction) orient(component.name, component);
    components.push_back(std::move(component));
  }
  if (const auto late = late_start(first, step); !mistakes.any() && !late.empty())
    components[0].warnings.push_back(late);
  if (options.columns.empty() && components.size() > 1)
    components[0].warnings.push_back(
        fmt::format("a time and {} columns; state which is which, such as columns = "
                    "\"time,h1,h2\"",
                    components.size()));
  return components;
}

}  // namespace

bool recognises_plain_text(const SourceFile& file) { return has_plain_rows(file); }

std::vector<Component> read_plain_text(const SourceFile& file, const ReadOptions& options) {
  Mistakes mistakes(file.name());
  PlainRows rows = plain_rows(file, mistakes);
  refuse_spectra(rows, file.name());
  if (rows.doubtful_commas && !options.si_per_count && !rows.lines.empty())
    mistakes.add(rows.lines[0], 1,
                 "commas between whole numbers: decimal commas are not read, write points (and "
                 "whole numbers as 12.)");
  const CountRow count = take_count_row(rows);
  if (count.line > 0 && !mistakes.any())
    check_count(count.count, "the first row", count.line, rows.values.size(), mistakes);
  const PlainColumns columns = plain_columns(rows, count.line > 0, options, mistakes);
  const std::size_t samples = columns.samples ? rows.values.size() : rows.lengths.size();
  if (samples < 2) mistakes.add(fmt::format("{} samples are no record (2 at least)", samples));

  const bool table = !columns.samples && !mistakes.any();
  auto components = table ? from_table(rows, columns, count, options, mistakes)
                          : one_component(rows, count, options, mistakes);
  mistakes.throw_if_any();
  for (Component& component : components) set_header(rows, component);
  warn_of_text(rows, components[0]);
  return components;
}

}  // namespace gurney
