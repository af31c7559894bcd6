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

std::vector<double> column(const PlainRows& rows, std::size_t at, std::size_t width) {
  std::vector<double> values;
  for (std::size_t i = at; i < rows.values.size(); i += width) values.push_back(rows.values[i]);
  return values;
}

/// The last line of text, if it is the title of the only column: `Acc [g]`.
std::vector<ColumnTitle> only_title(const PlainRows& rows) {
  constexpr std::size_t kLongestLine = 2000;
  if (rows.header.empty() || rows.header.back().size() > kLongestLine) return {};
  const auto line = left_trimmed(rows.header.back(), "#% \t");
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

/// The quantity other than acceleration that a line names beside it: `Time Acc Vel`.
std::optional<std::string_view> quantity_beside_acceleration(std::string_view text) {
  std::string line;
  for (const auto word : words_of(text, " \t,;:()[]=#%*\"/_")) {
    if (number(word)) return {};  // the value of something
    if (quantity_in(word) != "acceleration") line += fmt::format("{} ", word);
  }
  return quantity_in(line);
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

std::string a_or_an(const std::string& noun) {
  return (std::string_view("aeiou").find(noun[0]) == kNone ? "a " : "an ") + noun;
}

class PlainReader : LayoutReader {
 public:
  /// @param cells  plain_cells() of `original`; must live as long
  PlainReader(const SourceFile& original, const PlainCells& cells, const ReadOptions& given)
      : LayoutReader(cells.file ? *cells.file : original, given), cells_(cells) {}

  std::vector<Component> read() {
    rows_ = plain_rows(file, errors);
    refuse_spectra(rows_, file);
    refuse_doubtful_marks();
    leading_ = take_leading_numbers(rows_, options, errors);
    if (leading_.count > 0 && !errors.any())
      check_count({leading_.count, "the first row", leading_.line},
                  leading_.of_rows ? rows_.lengths.size() : rows_.values.size());
    const std::size_t width = rows_.width();
    const bool has_columns =
        width > 1 && options.columns != "samples" && (leading_.count == 0 || leading_.of_rows);
    const TableTitles titles = has_columns ? table_titles(rows_, width) : TableTitles();
    refuse_spectra(titles, options.columns.empty(), rows_, file);
    const PlainColumns columns = plain_columns(titles, leading_.count > 0 && !leading_.of_rows);
    check_enough(static_cast<double>(columns.samples ? rows_.values.size() : rows_.lengths.size()),
                 0);

    const bool is_table = !columns.samples && !errors.any();
    facts_ = plain_facts(rows_, is_table ? titles.lines : std::vector<std::size_t>(), errors);
    title_line_ = titles.any()                 ? titles.line
                  : rows_.header_lines.empty() ? 1
                                               : rows_.header_lines.back();
    some_state_a_unit_ = std::ranges::any_of(titles.titles, [](const ColumnTitle& title) {
      return acceleration_unit(title.unit).has_value();
    });
    auto components =
        checked(is_table ? table_components(columns, titles.titles) : only_component());
    for (Component& component : components) set_header(rows_, component);
    warn(components[0]);
    return components;
  }

 private:
  /// No other error matters before the decimal mark is known.
  void refuse_doubtful_marks() {
    if (rows_.lines.empty()) return;
    if (cells_.mixed_marks)
      error(rows_.lines[0],
            "semicolons part the cells, but the numbers have commas and points: which is the "
            "decimal mark? Write points only");
    if (rows_.doubtful_commas && !options.si_per_count)
      error(rows_.lines[0],
            "commas between whole numbers: decimal commas are read only where semicolons or "
            "tabs part the cells; write points (and whole numbers as 12.)");
    if (cells_.mixed_marks || (rows_.doubtful_commas && !options.si_per_count))
      errors.throw_if_any();
  }

  PlainColumns named_columns() {
    const std::vector<std::string> known = {"time", "h1", "h2", "vertical", "skip", "samples"};
    const std::string& text = options.columns;
    const auto names = names_in(text);
    PlainColumns result;
    result.samples = names == std::vector<std::string>{"samples"};
    if (result.samples) return result;
    bool component = false;
    for (auto name = names.begin(); name != names.end(); ++name) {
      PlainColumns::Column column;
      if (*name == "time") {
        column.kind = Kind::kTime;
      } else if (*name == "skip") {
        column.kind = Kind::kSkip;
      } else {
        const auto at = std::ranges::find(kDirections, *name, name_of);
        if (at == kDirections.end())
          errors.add(fmt::format("columns = \"{}\": unknown name '{}'{}", text, *name,
                                 config::suggestion(*name, known)));
        else
          column.direction = *at;
        component = true;
      }
      if (*name != "skip" && std::find(names.begin(), name, *name) != name)
        errors.add(fmt::format("columns = \"{}\": '{}' is named twice", text, *name));
      result.columns.push_back(column);
    }
    if (!component)
      errors.add(fmt::format("columns = \"{}\" names no component: h1, h2 or vertical", text));
    return result;
  }

  /// The user's names or else: one number in a row, a column that grows from row to row (a time: the
  /// first, or the one with that title), or titles that all are of accelerations say it.
  /// @param stated  the file states how many samples it has, as many as it has numbers
  PlainColumns plain_columns(const TableTitles& titles, bool stated) {
    const bool named = !options.columns.empty();
    PlainColumns result;
    if (named) result = named_columns();
    if (rows_.lengths.empty() || errors.any()) return result;

    const std::size_t odd = odd_row(rows_), width = rows_.lengths[0];
    const bool even = odd == rows_.lengths.size();
    const bool wrapped = rows_.width() > 0;  // only the last row may be shorter
    const bool samples = result.samples || (!named && stated);
    if (samples ? !wrapped && !stated : !even && (!wrapped || named)) {
      error(rows_.lines[odd],
            fmt::format("{} numbers in a row, the first row has {}", rows_.lengths[odd], width));
    } else if (samples || (!named && width == 1)) {
      result.samples = true;
    } else if (named) {
      if (result.columns.size() != width)
        error(rows_.lines[0], fmt::format("columns = \"{}\" names {} columns, but the rows have {}",
                                          options.columns, result.columns.size(), width));
    } else if (const auto time = time_column(rows_, titles, width); even && time) {
      result.columns.resize(width);
      result.columns[*time].kind = Kind::kTime;
      if (*time > 0 && names_index(titles.titles[0])) {
        result.columns[0].kind = Kind::kSkip;
        result.skipped_index = titles.titles[0].text;
      }
    } else if (even && are_components(titles)) {
      result.columns.resize(width);
    } else if (!even && odd + 1 == rows_.lengths.size() && column_grows(rows_, 0, width)) {
      refuse(rows_.lines[odd], fmt::format("{} of {} numbers in the last row: the file seems to be "
                                           "cut",
                                           rows_.lengths[odd], width));
    } else {
      error(rows_.lines[0], fmt::format("{} numbers in a row, and the first is no time that grows "
                                        "from row to row; {}",
                                        width, kHowToState));
    }
    if (samples) result.samples = true;
    return result;
  }

  void refuse_other_quantities(const ColumnTitle& title) {
    if (!title.quantity.empty())
      errors.add(fmt::format(
          "a record must be acceleration, but the column '{}' is {}; name the columns of "
          "accelerations, such as columns = \"time,h1,skip\"",
          title.text, a_or_an(title.quantity)));
  }

  /// The unit that a title and the text state, if any; errors if they are none or contradict.
  std::optional<AccelerationUnit> stated_unit(const ColumnTitle& title, std::size_t line) {
    const auto stated = acceleration_unit(title.unit);
    if (!title.unit.empty() && !stated && title.quantity.empty())
      error(line, fmt::format("the column '{}' states '{}', which is not a unit of acceleration: "
                              "{} are allowed",
                              title.text, title.unit, kAccelerationUnits));
    if (!title.factor.empty())
      error(line, fmt::format("the column '{}' has a factor behind its unit ('{}'): does it belong "
                              "to the numbers or to the unit? Scale the numbers and leave the "
                              "factor out",
                              title.text, title.factor));
    if (stated && facts_.unit && stated->to_si != facts_.unit->to_si)
      error(line,
            fmt::format("the column '{}' states the unit {}, but line {} states {}", title.text,
                        stated->name, errors.line_in_file(facts_.unit_line), facts_.unit->name));
    return stated ? stated : facts_.unit;
  }

  /// Unit of one column: stated by its title, by the text, by the user, or by some of them.
  AccelerationUnit unit_of(const ColumnTitle& title) {
    const std::size_t line = title.unit.empty() ? facts_.unit_line : title_line_;
    const auto stated = stated_unit(title, line);
    if (!title.quantity.empty() || (!title.unit.empty() && !stated)) return {"", 1};
    if (options.si_per_count) {
      if (stated)
        error(line, fmt::format("count_m_per_s2 is for raw counts, but the file states the unit {}",
                                stated->name));
      return {"counts", *options.si_per_count};
    }
    if (!stated && some_state_a_unit_ && !title.text.empty() && options.columns.empty()) {
      error(title_line_, fmt::format("the column '{}' states no unit, but others do; name the "
                                     "columns of accelerations, such as columns = \"time,h1,skip\"",
                                     title.text));
      return {"", 1};
    }
    // One error for all columns of a unit that is missing or contradicts that of the user.
    const auto given = acceleration_unit(options.unit);
    const bool is_wrong = stated ? given && given->to_si != stated->to_si : !given;
    if (is_wrong && unit_reported_) return {"", 1};
    unit_reported_ = is_wrong;
    return agreed_unit(stated, line);
  }

  double time_step() {
    if (leading_.line > 0 && leading_.time_step > 0) {
      check_step(facts_, leading_.time_step, "the first row", errors);
      return agreed_time_step(leading_.time_step, leading_.line);
    }
    if (options.time_step) {  // the text may be rounded
      check_step(facts_, *options.time_step, "time_step_s was given as", errors);
      return *options.time_step;
    }
    return agreed_time_step(facts_.time_step, facts_.step_line);
  }

  /// Seconds in the unit of a column of times.
  double time_unit_of(const ColumnTitle& title) {
    if (title.unit.empty()) return facts_.time_unit;
    const auto unit = time_unit(title.unit);
    if (!unit && lower(title.name).starts_with('t'))
      error(title_line_, fmt::format("the column '{}' states '{}', which is not a unit of time: s, "
                                     "ms, us or min are allowed",
                                     title.text, title.unit));
    return unit.value_or(1);
  }

  double step_of(const std::vector<double>& times) {
    const double step = even_step(times, rows_.lines, errors);
    if (errors.any()) return step;
    checked_time_step({step, "the time step", rows_.lines[0]});
    check_step(facts_, step, "the times have", errors);
    if (leading_.time_step > 0 && std::abs(leading_.time_step - step) > kTimeTolerance * step)
      error(leading_.line,
            fmt::format("the first row states a time step of {} s, but the times have {} s",
                        leading_.time_step, step));
    return step;
  }

  /// Tables beside each other: all their times must be those of the first.
  void refuse_other_times(const std::vector<ColumnTitle>& titles, std::size_t time) {
    const std::size_t width = titles.size();
    for (std::size_t k = time + 1; k < width; ++k)
      if (titles[k].quantity == "time" && column(rows_, k, width) != column(rows_, time, width))
        error(title_line_, fmt::format("columns {} and {} are both times ('{}' and '{}') and "
                                       "differ; save the tables as files of their own",
                                       time + 1, k + 1, titles[time].text, titles[k].text));
  }

  /// Without titles that fit, text such as `Time Acc Vel` says that some columns are velocities.
  void refuse_unnamed_quantities() {
    for (std::size_t i = 0; i < rows_.header.size(); ++i)
      if (const auto quantity = quantity_beside_acceleration(rows_.header[i].substr(0, 2000)))
        return error(rows_.header_lines[i],
                     fmt::format("the text speaks of {} ('{}'), but no row of titles says which "
                                 "column that is; name the columns of accelerations, such as "
                                 "columns = \"time,h1,skip\"",
                                 *quantity, rows_.header[i].substr(0, 80)));
  }

  Component component(const std::optional<Direction>& stated, const ColumnTitle& title,
                      const std::vector<double>& values, double step) {
    refuse_other_quantities(title);
    if (title.is_doubtful && stated != Direction::kVertical)
      error(title_line_,
            fmt::format("the column '{}' may be a velocity, a displacement or the vertical; say "
                        "which by columns, such as \"time,vertical\" or \"time,h1,skip\"",
                        title.text));
    if (const auto wrong = axis_error(values); !stated && !wrong.empty())
      error(rows_.lines[0], fmt::format("{}; name the columns of accelerations, such as columns = "
                                        "\"skip,time,h1\"",
                                        wrong));
    Component component = component_of(values, unit_of(title), step);
    component.name = title.name;
    orient(title, stated, component);
    return component;
  }

  /// A direction that the text states for the only component, unless its title does.
  void take_direction(Component& component) const {
    if (!facts_.component.empty() && !component.azimuth && !component.direction)
      name_and_orient(facts_.component, component);
  }

  /// The component of numbers that are samples row by row.
  std::vector<Component> only_component() {
    const auto titles = only_title(rows_);
    const ColumnTitle title = titles.empty() ? ColumnTitle{} : titles[0];
    refuse_other_quantities(title);
    const AccelerationUnit unit = unit_of(title);
    if (const auto wrong = axis_error(rows_.values); !wrong.empty()) error(rows_.lines[0], wrong);
    Component component = component_of(rows_.values, unit, time_step());
    take_direction(component);
    return {component};
  }

  /// The components of a table: a column each, with unit and direction as title, text and user say.
  /// Columns of other quantities are left out, with a warning, where all others are accelerations by
  /// their titles; else they are errors.
  /// @param titles  one for each column, or none
  std::vector<Component> table_components(PlainColumns columns, std::vector<ColumnTitle> titles) {
    const std::size_t width = columns.columns.size();
    const bool has_titles = !titles.empty(), named = !options.columns.empty();
    titles.resize(width);
    const auto time = std::ranges::find(columns.columns, Kind::kTime, &PlainColumns::Column::kind);
    const auto at = static_cast<std::size_t>(time - columns.columns.begin());
    std::vector<double> times = {0};
    if (at < width) {
      times = column(rows_, at, width);
      const double unit = time_unit_of(titles[at]);
      for (double& each : times) each *= unit;
    }
    const double step = at < width ? step_of(times) : time_step();

    const std::string note = named ? "" : skip_other_quantities(columns, titles);
    if (!named && !has_titles && width > 2) refuse_unnamed_quantities();
    refuse_other_times(titles, at);
    std::vector<Component> components;
    for (std::size_t k = 0; k < width; ++k) {
      if (columns.columns[k].kind != Kind::kComponent) continue;
      components.push_back(
          component(columns.columns[k].direction, titles[k], column(rows_, k, width), step));
      if (components.back().name.empty()) components.back().name = fmt::format("column {}", k + 1);
    }
    if (components.size() == 1 && !named) take_direction(components[0]);
    auto& warnings = components[0].warnings;
    if (const auto late = late_start(times[0], step); !errors.any() && !late.empty())
      warnings.push_back(late);
    if (!note.empty()) warnings.push_back(note);
    if (!columns.skipped_index.empty())
      warnings.push_back(
          fmt::format("the first column, '{}', counts the rows: skipped", columns.skipped_index));
    const bool all_known = std::ranges::all_of(
        components, [](const Component& each) { return each.azimuth || each.direction; });
    if (!named && components.size() > 1 && !all_known)
      warnings.push_back(fmt::format(
          "a time and {} columns; state which is which, such as columns = \"time,h1,h2\"",
          components.size()));
    return components;
  }

  /// Warns of what was skipped, and of statements of the text that the samples do not fulfil.
  void warn(Component& component) const {
    warn_of_text(rows_, component);
    auto& warnings = component.warnings;
    const auto held = static_cast<double>(component.acceleration.size());
    if (facts_.count && *facts_.count != held)
      warnings.push_back(fmt::format("line {} states {} samples, but the file holds {}",
                                     errors.line_in_file(facts_.count_line), *facts_.count, held));
    if (facts_.factor_line > 0 && !options.si_per_count)
      warnings.push_back(fmt::format("line {} states a factor ('{}'): it was not applied",
                                     errors.line_in_file(facts_.factor_line),
                                     trimmed(file.lines()[facts_.factor_line - 1]).substr(0, 60)));
    if (!leading_.warning.empty()) warnings.push_back(leading_.warning);
    if (!cells_.first_time.empty())
      warnings.push_back(fmt::format(
          "the first row is of {}; the motion starts there, at 0 s of the run", cells_.first_time));
  }

  const PlainCells& cells_;
  PlainRows rows_;
  LeadingNumbers leading_;
  PlainFacts facts_;
  std::size_t title_line_ = 1;      ///< in the file, from 1
  bool some_state_a_unit_ = false;  ///< titles of columns of accelerations do
  bool unit_reported_ = false;      ///< as missing or contradicted, once for all columns
};

}  // namespace

bool recognises_plain_text(const SourceFile& file) { return has_plain_rows(file); }

/// @throws Error if unit, time step or the meaning of the columns are neither stated by the file
///         nor by the options, for spectra, velocities and displacements that say so, what is no
///         number, rows of unequal length, and times that are not even.
std::vector<Component> read_plain_text(const SourceFile& file, const ReadOptions& options) {
  const PlainCells cells = plain_cells(file);
  return PlainReader(file, cells, options).read();
}

}  // namespace gurney::groundmotions
