#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "groundmotions/formats/column_title.h"
#include "groundmotions/formats/header_text.h"
#include "groundmotions/formats/numbers.h"
#include "groundmotions/formats/plain_columns.h"
#include "groundmotions/formats/plain_facts.h"
#include "groundmotions/formats/plain_rows.h"
#include "groundmotions/formats/readers.h"
#include "groundmotions/formats/stated.h"
#include "groundmotions/formats/time_column.h"
#include "groundmotions/formats/unit_text.h"
#include "groundmotions/formats/words.h"

namespace gurney::groundmotions {

namespace {

/// Tables that look like records but are none; their other errors do not matter.
void refuse_spectra(const PlainRows& rows, const SourceFile& file) {
  FileErrors errors(file);
  for (const std::string_view line : rows.header) {
    const std::string text = lower(line);
    for (const char* word : {"psa", "rotd", "spectral", "spectrum", "spectra", "arias"})
      if (text.find(word) != std::string::npos) {
        errors.add(fmt::format(
            "a record must be an acceleration history, but the header speaks of '{}' ('{}')", word,
            line.substr(0, 80)));
        errors.throw_if_any();
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

/// Unit of one column: stated by its title, by the text, by the user, or by some of them.
struct ColumnUnit {
  std::string name;
  double to_si = 1;
};

/// What all columns share.
struct Table {
  const PlainRows& rows;
  const PlainFacts& facts;
  const CountRow& count;
  const ReadOptions& options;
  FileErrors& errors;

  std::size_t title_line() const {
    return rows.header_lines.empty() ? 1 : rows.header_lines.back();
  }
};

void refuse_other_quantities(const ColumnTitle& title, const Table& table) {
  if (!title.quantity.empty())
    table.errors.add(
        fmt::format("a record must be acceleration, but the column '{}' is a {}; name "
                    "the columns of accelerations, such as columns = \"time,h1,skip\"",
                    title.text, title.quantity));
}

ColumnUnit unit_of(const ColumnTitle& title, const Table& table) {
  const auto& [rows, facts, count, options, errors] = table;
  const std::size_t line = title.unit.empty() ? facts.unit_line : table.title_line();
  auto stated = acceleration_unit(title.unit);
  if (!title.unit.empty() && !stated && title.quantity.empty())
    errors.add(line, 1,
               fmt::format("the column '{}' states '{}', which is not a unit of acceleration: {} "
                           "are allowed",
                           title.text, title.unit, kAccelerationUnits));
  if (stated && facts.unit && stated->to_si != facts.unit->to_si)
    errors.add(line, 1,
               fmt::format("the column '{}' states the unit {}, but line {} states {}", title.text,
                           stated->name, errors.line_in_file(facts.unit_line), facts.unit->name));
  if (!stated) stated = facts.unit;
  if (!title.quantity.empty() || (!title.unit.empty() && !stated)) return {};
  if (options.si_per_count) {
    if (stated)
      errors.add(line, 1,
                 fmt::format("count_m_per_s2 is for raw counts, but the file states the unit {}",
                             stated->name));
    return {"counts", *options.si_per_count};
  }
  const AccelerationUnit unit = agreed_unit(stated, line, options, errors);
  return {unit.name, unit.to_si};
}

void set_header(const PlainRows& rows, Component& component) {
  constexpr std::size_t kShown = 20;
  for (std::size_t i = 0; i < std::min(kShown, rows.header.size()); ++i)
    component.header.emplace_back(fmt::format("text {}", i + 1), rows.header[i]);
}

void warn_of_text(const PlainRows& rows, Component& component) {
  std::size_t count = 0;
  for (const auto line : rows.header) count += std::string_view("#%/").find(line[0]) == line.npos;
  if (count > 0)
    component.warnings.push_back(
        fmt::format("{} {} of text before the numbers, skipped; the last is '{}'", count,
                    count == 1 ? "line" : "lines", rows.header.back().substr(0, 60)));
  if (!rows.end.empty())
    component.warnings.push_back(
        fmt::format("{} {} after the numbers, skipped: '{}'", rows.end.size(),
                    rows.end.size() == 1 ? "line" : "lines", rows.end[0].substr(0, 60)));
}

double time_step_of(const Table& table) {
  const auto& [rows, facts, count, options, errors] = table;
  if (count.line > 0) {
    check_step(facts, count.time_step, "the first row", errors);
    return agreed_time_step(count.time_step, count.line, options, errors);
  }
  if (options.time_step) {  // the text may be rounded
    check_step(facts, *options.time_step, "time_step_s was given as", errors);
    return *options.time_step;
  }
  return agreed_time_step(facts.time_step, facts.step_line, options, errors);
}

std::vector<double> column(const PlainRows& rows, std::size_t at, std::size_t width) {
  std::vector<double> values;
  for (std::size_t i = at; i < rows.values.size(); i += width) values.push_back(rows.values[i]);
  return values;
}

/// The last line of text, if it is the title of the only column: `Acc [g]`.
std::vector<ColumnTitle> only_title(const PlainRows& rows) {
  if (rows.header.empty()) return {};
  auto line = rows.header.back();
  line.remove_prefix(std::min(line.find_first_not_of("#% \t"), line.size()));
  const bool has_bracket = line.ends_with(')') || line.ends_with(']');
  if (!has_bracket || !quantity_in(line) || unit_text_in(line)) return {};
  return parsed_titles({std::string(line)});
}

std::vector<Component> one_component(const Table& table) {
  const auto titles = only_title(table.rows);
  const ColumnTitle title = titles.empty() ? ColumnTitle{} : titles[0];
  refuse_other_quantities(title, table);
  const ColumnUnit unit = unit_of(title, table);
  Component component;
  component.time_step = time_step_of(table);
  component.unit = unit.name;
  component.acceleration = scaled(table.rows.values, unit.to_si);
  return {component};
}

/// Seconds in the unit of a column of times.
double time_unit_of(const ColumnTitle& title, const Table& table) {
  if (title.unit.empty()) return table.facts.time_unit;
  const auto unit = time_unit(title.unit);
  if (!unit && lower(title.name).starts_with('t'))
    table.errors.add(table.title_line(), 1,
                     fmt::format("the column '{}' states '{}', which is not a unit of time: s, "
                                 "ms, us or min are allowed",
                                 title.text, title.unit));
  return unit.value_or(1);
}

/// @returns the first of the times [s]
double take_times(std::vector<double> times, const ColumnTitle& title, const Table& table,
                  double& step) {
  const auto& [rows, facts, count, options, errors] = table;
  const std::string name = lower(title.name);
  if (name.starts_with("per") || name.starts_with("freq"))
    errors.add(table.title_line(), 1,
               fmt::format("a record must be a history, but the first column is '{}'", title.text));
  const double unit = time_unit_of(title, table);
  for (double& time : times) time *= unit;
  step = even_step(times, rows.lines, errors);
  if (errors.any()) return times[0];
  checked_time_step(step, "the time step", rows.lines[0], options, errors);
  check_step(facts, step, "the times have", errors);
  return times[0];
}

std::vector<Component> from_table(const PlainColumns& columns, std::vector<ColumnTitle> titles,
                                  const Table& table) {
  using Kind = PlainColumns::Kind;
  const auto& [rows, facts, count, options, errors] = table;
  const std::size_t width = columns.columns.size();
  titles.resize(width);
  double step = 0, first = 0;
  const auto time = std::ranges::find(columns.columns, Kind::kTime, &PlainColumns::Column::kind);
  const auto at = static_cast<std::size_t>(time - columns.columns.begin());
  if (at == width)
    step = time_step_of(table);
  else
    first = take_times(column(rows, at, width), titles[at], table, step);

  std::vector<Component> components;
  for (std::size_t k = 0; k < width; ++k) {
    if (columns.columns[k].kind != Kind::kComponent) continue;
    const ColumnTitle& title = titles[k];
    const auto& stated = columns.columns[k].direction;
    refuse_other_quantities(title, table);
    if (title.is_doubtful && stated != Direction::kVertical)
      errors.add(table.title_line(), 1,
                 fmt::format("the column '{}' may be a velocity or the vertical; say which by "
                             "columns, such as \"time,vertical\" or \"time,h1,skip\"",
                             title.text));
    const ColumnUnit unit = unit_of(title, table);
    Component component;
    component.time_step = step;
    component.unit = unit.name;
    component.acceleration = scaled(column(rows, k, width), unit.to_si);
    component.name = title.name;
    orient(title, stated, component);
    if (component.name.empty()) component.name = fmt::format("column {}", k + 1);
    components.push_back(std::move(component));
  }
  if (const auto late = late_start(first, step); !errors.any() && !late.empty())
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

/// @throws Error if unit, time step or the meaning of the columns are neither stated by the file
///         nor by the options, for spectra, velocities and displacements that say so, what is no
///         number, rows of unequal length, and times that are not even.
std::vector<Component> read_plain_text(const SourceFile& file, const ReadOptions& options) {
  FileErrors errors(file);
  PlainRows rows = plain_rows(file, errors);
  refuse_spectra(rows, file);
  if (rows.doubtful_commas && !options.si_per_count && !rows.lines.empty())
    errors.add(rows.lines[0], 1,
               "commas between whole numbers: decimal commas are not read, write points (and "
               "whole numbers as 12.)");
  const CountRow count = take_count_row(rows);
  if (count.line > 0 && !errors.any())
    check_count(count.count, "the first row", count.line, rows.values.size(), errors);
  const PlainColumns columns = plain_columns(rows, count.line > 0, options, errors);
  const std::size_t samples = columns.samples ? rows.values.size() : rows.lengths.size();
  if (samples < 2) errors.add(fmt::format("{} samples are no record (2 at least)", samples));

  const bool is_table = !columns.samples && !errors.any();
  const auto titles = parsed_titles(is_table ? column_titles(rows, columns.columns.size())
                                             : std::vector<std::string>());
  const PlainFacts facts = plain_facts(rows, !titles.empty(), errors);
  const Table table{rows, facts, count, options, errors};
  auto components = is_table ? from_table(columns, titles, table) : one_component(table);
  errors.throw_if_any();
  for (Component& component : components) set_header(rows, component);
  warn_of_text(rows, components[0]);
  return components;
}

}  // namespace gurney::groundmotions
