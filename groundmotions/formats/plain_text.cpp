#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "engine/config/nearest_name.h"
#include "groundmotions/formats/column_title.h"
#include "groundmotions/formats/format.h"
#include "groundmotions/formats/header_text.h"
#include "groundmotions/formats/numbers.h"
#include "groundmotions/formats/orientation.h"
#include "groundmotions/formats/plain_facts.h"
#include "groundmotions/formats/plain_rows.h"
#include "groundmotions/formats/readers.h"
#include "groundmotions/formats/source_file.h"
#include "groundmotions/formats/stated.h"
#include "groundmotions/formats/time_column.h"
#include "groundmotions/formats/words.h"

namespace gurney::groundmotions {

namespace {

/// Meaning of the numbers in plain rows.
struct PlainColumns {
  enum class Kind { kTime, kComponent, kSkip };
  struct Column {
    Kind kind = Kind::kComponent;
    std::optional<Direction> direction;
  };

  bool samples = false;         ///< one component, row by row; `columns` is empty
  std::vector<Column> columns;  ///< one for each number of a row
  std::string skipped_index;    ///< title of a first column that counts the rows; may be empty
};

using Kind = PlainColumns::Kind;

constexpr const char* kHowToState =
    "state columns = \"samples\" if they are samples row by row, or name them, such as columns = "
    "\"time,h1,h2,vertical\" or \"h1,skip\"";

std::vector<std::string> names_in(std::string_view text) {
  std::vector<std::string> names;
  for (std::size_t begin = 0; begin <= text.size();) {
    const auto end = std::min(text.find(',', begin), text.size());
    names.emplace_back(trimmed(text.substr(begin, end - begin)));
    begin = end + 1;
  }
  return names;
}

PlainColumns from_names(const std::string& text, FileErrors& errors) {
  const std::vector<std::string> known = {"time", "h1", "h2", "vertical", "skip", "samples"};
  const auto names = names_in(text);
  PlainColumns result;
  if (names == std::vector<std::string>{"samples"}) {
    result.samples = true;
    return result;
  }
  bool component = false;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string& name = names[i];
    PlainColumns::Column column;
    if (name == "time") {
      column.kind = Kind::kTime;
    } else if (name == "skip") {
      column.kind = Kind::kSkip;
    } else {
      const auto at = std::ranges::find(kDirections, name, name_of);
      if (at == kDirections.end())
        errors.add(fmt::format("columns = \"{}\": unknown name '{}'{}", text, name,
                               config::suggestion(name, known)));
      else
        column.direction = *at;
      component = true;
    }
    if (name != "skip" && std::find(names.begin(), names.begin() + static_cast<long>(i), name) !=
                              names.begin() + static_cast<long>(i))
      errors.add(fmt::format("columns = \"{}\": '{}' is named twice", text, name));
    result.columns.push_back(column);
  }
  if (!component)
    errors.add(fmt::format("columns = \"{}\" names no component: h1, h2 or vertical", text));
  return result;
}

/// The first row whose length differs from that of the first row.
std::size_t odd_row(const PlainRows& rows) {
  std::size_t i = 1;
  while (i < rows.lengths.size() && rows.lengths[i] == rows.lengths[0]) ++i;
  return i;
}

bool column_grows(const PlainRows& rows, std::size_t column, std::size_t width) {
  for (std::size_t i = width + column; i < rows.values.size(); i += width)
    if (!(rows.values[i] > rows.values[i - width])) return false;
  return rows.lengths.size() > 2;
}

/// The column of times: the one with that title, or else the first if it grows.
std::optional<std::size_t> time_column(const PlainRows& rows, const TableTitles& titles,
                                       std::size_t width) {
  const auto named = std::ranges::find_if(titles.titles, names_time);
  const auto at = static_cast<std::size_t>(named - titles.titles.begin());
  if (named != titles.titles.end() && column_grows(rows, at, width)) return at;
  return column_grows(rows, 0, width) ? std::optional<std::size_t>(0) : std::nullopt;
}

bool is_component(const ColumnTitle& title) {
  Component component;
  component.acceleration = Eigen::Vector2d::Zero();
  orient(title, {}, component);
  return title.quantity.empty() &&
         (title.is_acceleration() || component.azimuth || component.direction);
}

/// A table without times, of which each column is a component by its title.
bool are_components(const TableTitles& titles) {
  return titles.any() &&
         (titles.are_components || std::ranges::all_of(titles.titles, is_component));
}

/// @param options  `columns` if not empty, else: one number in a row, a column that grows from row to
///                 row (a time: the first, or the one with that title), or titles that all are of
///                 accelerations say it
/// @param stated   the file states how many samples it has, as many as it has numbers
/// Errors: names that are unknown or repeated, no component, another number of columns, rows of
/// unequal length, and rows that do not say what they are.
PlainColumns plain_columns(const PlainRows& rows, const TableTitles& titles, bool stated,
                           const ReadOptions& options, FileErrors& errors) {
  PlainColumns result;
  if (!options.columns.empty()) result = from_names(options.columns, errors);
  if (rows.lengths.empty() || errors.any()) return result;

  const std::size_t odd = odd_row(rows);
  const bool even = odd == rows.lengths.size();
  const bool wrapped = rows.width() > 0;  // only the last row may be shorter
  if (result.samples || (options.columns.empty() && stated)) {
    result.samples = true;
    if (!wrapped && !stated)
      errors.add(rows.lines[odd], 1,
                 fmt::format("{} numbers in a row, the first row has {}", rows.lengths[odd],
                             rows.lengths[0]));
    return result;
  }
  if (!even && !(wrapped && options.columns.empty())) {
    errors.add(rows.lines[odd], 1,
               fmt::format("{} numbers in a row, the first row has {}", rows.lengths[odd],
                           rows.lengths[0]));
    return result;
  }
  const std::size_t width = rows.lengths[0];
  if (!options.columns.empty()) {
    if (result.columns.size() != width)
      errors.add(rows.lines[0], 1,
                 fmt::format("columns = \"{}\" names {} columns, but the rows have {}",
                             options.columns, result.columns.size(), width));
    return result;
  }
  if (width == 1) {
    result.samples = true;
  } else if (const auto time = time_column(rows, titles, width); even && time) {
    result.columns.resize(width);
    result.columns[*time].kind = Kind::kTime;
    if (*time > 0 && names_index(titles.titles[0])) {
      result.columns[0].kind = Kind::kSkip;
      result.skipped_index = titles.titles[0].text;
    }
  } else if (even && are_components(titles)) {
    result.columns.resize(width);
  } else if (!even && odd + 1 == rows.lengths.size() && column_grows(rows, 0, width)) {
    errors.add(rows.lines[odd], 1,
               fmt::format("{} of {} numbers in the last row: the file seems to be cut",
                           rows.lengths[odd], width));
    errors.throw_if_any();
  } else {
    errors.add(rows.lines[0], 1,
               fmt::format("{} numbers in a row, and the first is no time that grows from row to "
                           "row; {}",
                           width, kHowToState));
  }
  return result;
}

/// Facts that all columns share.
struct PlainTable {
  const PlainRows& rows;
  const PlainFacts& facts;
  const LeadingNumbers& leading;
  const ReadOptions& options;
  FileErrors& errors;
  std::size_t title_line = 1;          ///< in the file, from 1
  bool some_state_a_unit = false;      ///< titles of columns of accelerations do
  mutable bool unit_reported = false;  ///< as missing or contradicted, once for all columns
};

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

/// The component of numbers that are samples row by row.
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

/// The components of a table: a column each, with unit and direction as title, text and user say.
/// Columns of other quantities are left out, with a warning, where all others are accelerations by
/// their titles; else they are errors.
/// @param titles  one for each column, or none
std::vector<Component> table_components(PlainColumns columns, std::vector<ColumnTitle> titles,
                                        const PlainTable& table) {
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

/// The text may state how many samples there are; fewer were cut off, which must be said.
void warn_of_count(const PlainFacts& facts, const FileErrors& errors, Component& component) {
  const auto held = static_cast<double>(component.acceleration.size());
  if (facts.count && *facts.count != held)
    component.warnings.push_back(fmt::format("line {} states {} samples, but the file holds {}",
                                             errors.line_in_file(facts.count_line), *facts.count,
                                             held));
}

/// Samples may still have to be multiplied by what the text states.
void warn_of_factor(const PlainFacts& facts, const SourceFile& file, const FileErrors& errors,
                    Component& component) {
  if (facts.factor_line == 0) return;
  component.warnings.push_back(fmt::format(
      "line {} states a factor ('{}'): it was not applied", errors.line_in_file(facts.factor_line),
      trimmed(file.lines()[facts.factor_line - 1]).substr(0, 60)));
}

void check_leading_count(const LeadingNumbers& leading, const PlainRows& rows, FileErrors& errors) {
  if (leading.count > 0 && !errors.any())
    check_count(leading.count, "the first row", leading.line,
                leading.of_rows ? rows.lengths.size() : rows.values.size(), errors);
}

bool states_a_unit(const ColumnTitle& title) { return acceleration_unit(title.unit).has_value(); }

/// No other error matters before the decimal mark is known.
void refuse_doubtful_marks(const PlainCells& cells, const PlainRows& rows,
                           const ReadOptions& options, FileErrors& errors) {
  if (rows.lines.empty()) return;
  if (cells.mixed_marks)
    errors.add(rows.lines[0], 1,
               "semicolons part the cells, but the numbers have commas and points: which is the "
               "decimal mark? Write points only");
  if (rows.doubtful_commas && !options.si_per_count)
    errors.add(rows.lines[0], 1,
               "commas between whole numbers: decimal commas are read only where semicolons or "
               "tabs part the cells; write points (and whole numbers as 12.)");
  if (cells.mixed_marks || (rows.doubtful_commas && !options.si_per_count)) errors.throw_if_any();
}

}  // namespace

bool recognises_plain_text(const SourceFile& file) { return has_plain_rows(file); }

/// @throws Error if unit, time step or the meaning of the columns are neither stated by the file
///         nor by the options, for spectra, velocities and displacements that say so, what is no
///         number, rows of unequal length, and times that are not even.
std::vector<Component> read_plain_text(const SourceFile& original, const ReadOptions& options) {
  const PlainCells cells = plain_cells(original);
  const SourceFile& file = cells.file ? *cells.file : original;
  FileErrors errors(file);
  PlainRows rows = plain_rows(file, errors);
  refuse_spectra(rows, file);
  refuse_doubtful_marks(cells, rows, options, errors);
  const LeadingNumbers leading = take_leading_numbers(rows, options, errors);
  check_leading_count(leading, rows, errors);
  const std::size_t width = rows.width();
  const bool has_columns =
      width > 1 && options.columns != "samples" && (leading.count == 0 || leading.of_rows);
  const TableTitles titles = has_columns ? table_titles(rows, width) : TableTitles();
  refuse_spectra(titles, options.columns.empty(), rows, file);
  const PlainColumns columns =
      plain_columns(rows, titles, leading.count > 0 && !leading.of_rows, options, errors);
  const std::size_t samples = columns.samples ? rows.values.size() : rows.lengths.size();
  check_enough(static_cast<double>(samples), 0, errors);

  const bool is_table = !columns.samples && !errors.any();
  const PlainFacts facts =
      plain_facts(rows, is_table ? titles.lines : std::vector<std::size_t>(), errors);
  const PlainTable table{.rows = rows,
                         .facts = facts,
                         .leading = leading,
                         .options = options,
                         .errors = errors,
                         .title_line = titles.any()                ? titles.line
                                       : rows.header_lines.empty() ? 1
                                                                   : rows.header_lines.back(),
                         .some_state_a_unit = std::ranges::any_of(titles.titles, states_a_unit)};
  auto components =
      is_table ? table_components(columns, titles.titles, table) : only_component(table);
  errors.throw_if_any();
  for (Component& component : components) set_header(rows, component);
  warn_of_text(rows, components[0]);
  warn_of_count(facts, errors, components[0]);
  if (!options.si_per_count) warn_of_factor(facts, file, errors, components[0]);
  if (!leading.warning.empty()) components[0].warnings.push_back(leading.warning);
  if (!cells.first_time.empty())
    components[0].warnings.push_back(fmt::format(
        "the first row is of {}; the motion starts there, at 0 s of the run", cells.first_time));
  return components;
}

}  // namespace gurney::groundmotions
