#include "groundmotions/formats/plain_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "groundmotions/formats/header_text.h"
#include "groundmotions/formats/numbers.h"
#include "groundmotions/formats/orientation.h"
#include "groundmotions/formats/stated.h"
#include "groundmotions/formats/time_column.h"
#include "groundmotions/formats/unit_text.h"
#include "groundmotions/formats/words.h"

namespace gurney::groundmotions {

namespace {

/// Unit of one column: stated by its title, by the text, by the user, or by some of them.
struct ColumnUnit {
  std::string name;
  double to_si = 1;
};

void refuse_other_quantities(const ColumnTitle& title, const PlainTable& table) {
  if (title.quantity.empty()) return;
  const bool is_vowel = std::string_view("aeiou").find(title.quantity[0]) != std::string_view::npos;
  table.errors.add(
      fmt::format("a record must be acceleration, but the column '{}' is {} {}; name the columns "
                  "of accelerations, such as columns = \"time,h1,skip\"",
                  title.text, is_vowel ? "an" : "a", title.quantity));
}

/// The unit that a title and the text state, if any; errors if they are none or contradict.
std::optional<AccelerationUnit> stated_unit(const ColumnTitle& title, const PlainTable& table,
                                            std::size_t line) {
  const auto& facts = table.facts;
  const auto stated = acceleration_unit(title.unit);
  if (!title.unit.empty() && !stated && title.quantity.empty())
    table.errors.add(line, 1,
                     fmt::format("the column '{}' states '{}', which is not a unit of "
                                 "acceleration: {} are allowed",
                                 title.text, title.unit, kAccelerationUnits));
  if (!title.factor.empty())
    table.errors.add(line, 1,
                     fmt::format("the column '{}' has a factor behind its unit ('{}'): does it "
                                 "belong to the numbers or to the unit? Scale the numbers and "
                                 "leave the factor out",
                                 title.text, title.factor));
  if (stated && facts.unit && stated->to_si != facts.unit->to_si)
    table.errors.add(
        line, 1,
        fmt::format("the column '{}' states the unit {}, but line {} states {}", title.text,
                    stated->name, table.errors.line_in_file(facts.unit_line), facts.unit->name));
  return stated ? stated : facts.unit;
}

ColumnUnit unit_of(const ColumnTitle& title, const PlainTable& table) {
  const auto& options = table.options;
  const std::size_t line = title.unit.empty() ? table.facts.unit_line : table.title_line;
  const auto stated = stated_unit(title, table, line);
  if (!title.quantity.empty() || (!title.unit.empty() && !stated)) return {};
  if (options.si_per_count) {
    if (stated)
      table.errors.add(line, 1,
                       fmt::format("count_m_per_s2 is for raw counts, but the file states the "
                                   "unit {}",
                                   stated->name));
    return {"counts", *options.si_per_count};
  }
  if (!stated && table.some_state_a_unit && !title.text.empty() && options.columns.empty()) {
    table.errors.add(table.title_line, 1,
                     fmt::format("the column '{}' states no unit, but others do; name the columns "
                                 "of accelerations, such as columns = \"time,h1,skip\"",
                                 title.text));
    return {};
  }
  // One error for all columns of a unit that is missing or contradicts that of the user.
  const auto given = acceleration_unit(options.unit);
  const bool is_wrong = stated ? given && given->to_si != stated->to_si : !given;
  if (is_wrong && table.unit_reported) return {};
  table.unit_reported = is_wrong;
  const AccelerationUnit unit = agreed_unit(stated, line, options, table.errors);
  return {unit.name, unit.to_si};
}

double time_step_of(const PlainTable& table) {
  const auto& facts = table.facts;
  const auto& leading = table.leading;
  const auto& options = table.options;
  auto& errors = table.errors;
  if (leading.line > 0 && leading.time_step > 0) {
    check_step(facts, leading.time_step, "the first row", errors);
    return agreed_time_step(leading.time_step, leading.line, options, errors);
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
  constexpr std::size_t kLongestLine = 2000;
  if (rows.header.empty() || rows.header.back().size() > kLongestLine) return {};
  auto line = rows.header.back();
  line.remove_prefix(std::min(line.find_first_not_of("#% \t"), line.size()));
  const bool has_bracket = line.ends_with(')') || line.ends_with(']');
  const bool is_word = line.find_first_of(" \t,;") == std::string_view::npos;  // "acc_g"
  if (!(has_bracket || is_word) || unit_text_in(line) || time_step_in(line)) return {};
  auto titles = parsed_titles({std::string(line)});
  if (is_word && acceleration_unit(titles[0].unit)) return titles;
  // A depth in m is no displacement.
  const std::string& quantity = titles[0].quantity;
  if (!quantity_in(line) && (quantity.empty() || quantity == "displacement")) titles.clear();
  return titles;
}

/// Seconds in the unit of a column of times.
double time_unit_of(const ColumnTitle& title, const PlainTable& table) {
  if (title.unit.empty()) return table.facts.time_unit;
  const auto unit = time_unit(title.unit);
  if (!unit && lower(title.name).starts_with('t'))
    table.errors.add(table.title_line, 1,
                     fmt::format("the column '{}' states '{}', which is not a unit of time: s, "
                                 "ms, us or min are allowed",
                                 title.text, title.unit));
  return unit.value_or(1);
}

/// @returns the first of the times [s]
double take_times(std::vector<double> times, const ColumnTitle& title, const PlainTable& table,
                  double& step) {
  auto& errors = table.errors;
  const double unit = time_unit_of(title, table);
  for (double& time : times) time *= unit;
  step = even_step(times, table.rows.lines, errors);
  if (errors.any()) return times[0];
  checked_time_step(step, "the time step", table.rows.lines[0], table.options, errors);
  check_step(table.facts, step, "the times have", errors);
  if (table.leading.time_step > 0 &&
      std::abs(table.leading.time_step - step) > kTimeTolerance * step)
    errors.add(table.leading.line, 1,
               fmt::format("the first row states a time step of {} s, but the times have {} s",
                           table.leading.time_step, step));
  return times[0];
}

/// Columns of velocities, volts and the like are left out where all others are accelerations by
/// their titles. @returns a note that names them, or nothing
std::string skip_other_quantities(PlainColumns& columns, const std::vector<ColumnTitle>& titles) {
  std::string note;
  std::vector<std::size_t> others;
  std::size_t accelerations = 0, components = 0;
  for (std::size_t k = 0; k < titles.size(); ++k) {
    if (columns.columns[k].kind != PlainColumns::Kind::kComponent) continue;
    ++components;
    accelerations += titles[k].is_acceleration();
    if (titles[k].quantity.empty()) continue;
    others.push_back(k);
    note +=
        fmt::format("{}'{}' ({})", note.empty() ? "" : ", ", titles[k].text, titles[k].quantity);
  }
  if (others.empty() || accelerations == 0 || accelerations + others.size() != components)
    return {};
  for (const std::size_t k : others) columns.columns[k].kind = PlainColumns::Kind::kSkip;
  return "columns that are no accelerations, skipped: " + note;
}

/// Tables beside each other: all their times must be those of the first.
void refuse_other_times(const std::vector<ColumnTitle>& titles, std::size_t time,
                        const PlainTable& table) {
  const std::size_t width = titles.size();
  for (std::size_t k = time + 1; k < width; ++k)
    if (titles[k].quantity == "time" &&
        column(table.rows, k, width) != column(table.rows, time, width))
      table.errors.add(table.title_line, 1,
                       fmt::format("columns {} and {} are both times ('{}' and '{}') and differ; "
                                   "save the tables as files of their own",
                                   time + 1, k + 1, titles[time].text, titles[k].text));
}

/// The quantity other than acceleration that a line names beside it: `Time Acc Vel`.
std::optional<std::string_view> quantity_beside_acceleration(std::string_view text) {
  std::string line;
  for (const auto word : words_of(text, " \t,;:()[]=#%*\"/_")) {
    if (number(word)) return {};  // the value of something
    if (quantity_in(word) != "acceleration") line += fmt::format("{} ", word);
  }
  return quantity_in(line);
}

/// Without titles that fit, text such as `Time Acc Vel` says that some columns are velocities.
void refuse_unnamed_quantities(const PlainTable& table) {
  for (std::size_t i = 0; i < table.rows.header.size(); ++i)
    if (const auto quantity = quantity_beside_acceleration(table.rows.header[i].substr(0, 2000))) {
      table.errors.add(table.rows.header_lines[i], 1,
                       fmt::format("the text speaks of {} ('{}'), but no row of titles says which "
                                   "column that is; name the columns of accelerations, such as "
                                   "columns = \"time,h1,skip\"",
                                   *quantity, table.rows.header[i].substr(0, 80)));
      return;
    }
}

Component component_of(const PlainColumns::Column& column_kind, const ColumnTitle& title,
                       const std::vector<double>& values, const PlainTable& table) {
  const auto& stated = column_kind.direction;
  refuse_other_quantities(title, table);
  if (title.is_doubtful && stated != Direction::kVertical)
    table.errors.add(
        table.title_line, 1,
        fmt::format(
            "the column '{}' may be a velocity, a displacement or the vertical; say which by "
            "columns, such as \"time,vertical\" or \"time,h1,skip\"",
            title.text));
  if (const auto error = axis_error(values); !stated && !error.empty())
    table.errors.add(table.rows.lines[0], 1,
                     fmt::format("{}; name the columns of accelerations, such as columns = "
                                 "\"skip,time,h1\"",
                                 error));
  const ColumnUnit unit = unit_of(title, table);
  Component component;
  component.unit = unit.name;
  component.acceleration = scaled(values, unit.to_si);
  component.name = title.name;
  orient(title, stated, component);
  return component;
}

bool columns_are_named(const PlainTable& table) { return !table.options.columns.empty(); }

/// A direction that the text states for the only component, unless its title does.
void take_direction(const PlainTable& table, Component& component) {
  if (table.facts.component.empty() || component.azimuth || component.direction) return;
  component.name = table.facts.component;
  orient(component.name, component);
}

/// Warns of columns that were taken without being named.
void warn_of_columns(const PlainColumns& columns, const PlainTable& table,
                     std::vector<Component>& components) {
  auto& warnings = components[0].warnings;
  if (!columns.skipped_index.empty())
    warnings.push_back(
        fmt::format("the first column, '{}', counts the rows: skipped", columns.skipped_index));
  const bool all_known = std::ranges::all_of(components, [](const Component& component) {
    return component.azimuth || component.direction;
  });
  if (table.options.columns.empty() && components.size() > 1 && !all_known)
    warnings.push_back(
        fmt::format("a time and {} columns; state which is which, such as columns = "
                    "\"time,h1,h2\"",
                    components.size()));
}

}  // namespace

std::vector<Component> only_component(const PlainTable& table) {
  const auto titles = only_title(table.rows);
  const ColumnTitle title = titles.empty() ? ColumnTitle{} : titles[0];
  refuse_other_quantities(title, table);
  const ColumnUnit unit = unit_of(title, table);
  if (const auto error = axis_error(table.rows.values); !error.empty())
    table.errors.add(table.rows.lines[0], 1, error);
  Component component;
  component.time_step = time_step_of(table);
  component.unit = unit.name;
  component.acceleration = scaled(table.rows.values, unit.to_si);
  take_direction(table, component);
  return {component};
}

std::vector<Component> table_components(PlainColumns columns, std::vector<ColumnTitle> titles,
                                        const PlainTable& table) {
  using Kind = PlainColumns::Kind;
  const std::size_t width = columns.columns.size();
  const bool has_titles = !titles.empty();
  titles.resize(width);
  double step = 0, first = 0;
  const auto time = std::ranges::find(columns.columns, Kind::kTime, &PlainColumns::Column::kind);
  const auto at = static_cast<std::size_t>(time - columns.columns.begin());
  if (at == width)
    step = time_step_of(table);
  else
    first = take_times(column(table.rows, at, width), titles[at], table, step);

  std::string note;
  if (table.options.columns.empty()) {
    note = skip_other_quantities(columns, titles);
    if (!has_titles && width > 2) refuse_unnamed_quantities(table);
  }
  refuse_other_times(titles, at, table);
  std::vector<Component> components;
  for (std::size_t k = 0; k < width; ++k) {
    if (columns.columns[k].kind != Kind::kComponent) continue;
    components.push_back(
        component_of(columns.columns[k], titles[k], column(table.rows, k, width), table));
    components.back().time_step = step;
    if (components.back().name.empty()) components.back().name = fmt::format("column {}", k + 1);
  }
  if (components.size() == 1 && !columns_are_named(table)) take_direction(table, components[0]);
  if (const auto late = late_start(first, step); !table.errors.any() && !late.empty())
    components[0].warnings.push_back(late);
  if (!note.empty()) components[0].warnings.push_back(note);
  warn_of_columns(columns, table, components);
  return components;
}

}  // namespace gurney::groundmotions
