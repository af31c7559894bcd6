#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

#include "engine/base/csv_row.h"
#include "engine/base/units.h"
#include "engine/config/nearest_name.h"
#include "groundmotions/formats/calendar.h"
#include "groundmotions/formats/column_title.h"
#include "groundmotions/formats/numbers.h"
#include "groundmotions/formats/readers.h"
#include "groundmotions/formats/source_file.h"
#include "groundmotions/formats/stated.h"
#include "groundmotions/formats/time_column.h"
#include "groundmotions/formats/words.h"
#include "groundmotions/formats/writers.h"

namespace gurney::groundmotions {

namespace {

struct Column {
  std::string name;
  const char* unit;
  double to_si;
  std::optional<Direction> direction;
};

/// Every column of accelerations that the format knows.
const std::vector<Column>& known_columns() {
  static const std::vector<Column> columns = [] {
    const std::pair<std::string, std::optional<Direction>> names[] = {
        {"x", Direction::kH1}, {"y", Direction::kH2}, {"z", Direction::kVertical}, {"a", {}}};
    std::vector<Column> result;
    for (const auto& [name, direction] : names) {
      result.push_back({name + "_m_per_s2", "m/s2", 1, direction});
      result.push_back({name + "_cm_per_s2", "cm/s2", 0.01, direction});
      result.push_back({name + "_g", "g", kStandardGravity, direction});
    }
    return result;
  }();
  return columns;
}

const Column* find_column(std::string_view name) {
  const auto at = std::ranges::find(known_columns(), name, &Column::name);
  return at == known_columns().end() ? nullptr : &*at;
}

bool is_content(std::string_view line) {
  line = trimmed(line);
  return !line.empty() && line[0] != '#';
}

std::size_t header_line(const SourceFile& file) {
  const auto at = std::ranges::find_if(file.lines(), is_content);
  return static_cast<std::size_t>(at - file.lines().begin());
}

std::vector<std::string> known_names() {
  std::vector<std::string> names = {"time_s"};
  for (const Column& column : known_columns()) names.emplace_back(column.name);
  return names;
}

/// Columns of a file in their order after time_s; unknown ones are null and errors.
std::vector<const Column*> columns_of(const SourceFile& file, std::size_t line,
                                      FileErrors& errors) {
  const auto cells = csv_row(file.lines()[line]);
  if (cells[0].text != "time_s") {
    errors.add(line + 1, cells[0].column,
               fmt::format("the first column must be time_s, got '{}'", cells[0].text));
    errors.throw_if_any();
  }
  std::vector<const Column*> columns;
  for (const CsvCell& cell : std::vector(cells.begin() + 1, cells.end())) {
    const Column* column = find_column(cell.text);
    if (!column)
      errors.add(line + 1, cell.column,
                 fmt::format("unknown column '{}'{}", cell.text,
                             config::suggestion(cell.text, known_names())));
    for (const Column* other : columns)
      if (column && other && column->name[0] == other->name[0])
        errors.add(line + 1, cell.column,
                   fmt::format("column '{}' repeats component {}", cell.text, column->name[0]));
    columns.push_back(column);
  }
  if (columns.empty()) errors.add(line + 1, 1, "no column of accelerations");
  if (columns.size() > 1 && std::ranges::any_of(columns, [](auto c) { return c && !c->direction; }))
    errors.add(line + 1, 1, "column a stands alone; with others, name it x, y or z");
  return columns;
}

void check_options(const ReadOptions& options, double step, FileErrors& errors) {
  if (!options.unit.empty())
    errors.add(fmt::format(
        "unit = \"{}\" was given, but the columns of this file state their units", options.unit));
  if (options.time_step && std::abs(*options.time_step - step) > 1e-6 * step)
    errors.add(fmt::format("the file has a time step of {} s, but time_step_s = {} was given", step,
                           *options.time_step));
}

constexpr std::string_view kAzimuth = "azimuth ", kDegrees = " deg", kStart = "start ";

/// 1994-01-17T12:30:55.000Z
std::string utc_text(double seconds) {
  using namespace std::chrono;
  const sys_time<milliseconds> time(milliseconds(std::llround(seconds * 1000)));
  const auto day = floor<days>(time);
  const year_month_day date(day);
  const hh_mm_ss clock(time - day);
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}.{:03}Z", static_cast<int>(date.year()),
                     static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                     clock.hours().count(), clock.minutes().count(), clock.seconds().count(),
                     clock.subseconds().count());
}

std::optional<double> azimuth_of(std::string_view text) {
  if (!text.ends_with(kDegrees)) return {};
  const auto degrees = number(trimmed(text.substr(0, text.size() - kDegrees.size())));
  if (!degrees || !(*degrees >= 0 && *degrees <= 360)) return {};
  return *degrees * kRadiansPerDegree;
}

std::string place_of(const Component& component) {
  return component.direction ? name_of(*component.direction) : "a";
}

/// One line; @returns what is wrong with it.
std::string read_fact(std::string_view fact, Component& component) {
  const bool is_start = fact.starts_with(kStart);
  auto& known = is_start ? component.start_time : component.azimuth;
  const std::string_view text = trimmed(fact.substr((is_start ? kStart : kAzimuth).size()));
  if (!is_start && component.direction == Direction::kVertical) return "a vertical has no azimuth";
  if (known) return fmt::format("'{}' is stated twice for {}", fact, place_of(component));
  known = is_start ? utc_seconds(text) : azimuth_of(text);
  if (known) return {};
  return is_start ? fmt::format("'{}': must be such as 1994-01-17T12:30:55.000Z", text)
                  : fmt::format("'{}': must be such as 318 deg, from 0 to 360", text);
}

}  // namespace

bool recognises_columns_csv(const SourceFile& file) {
  const std::size_t line = header_line(file);
  if (line == file.lines().size()) return false;
  const auto cells = csv_row(file.lines()[line]);
  if (cells.size() < 2) return false;
  if (std::ranges::any_of(cells, [](const CsvCell& cell) { return find_column(cell.text); }))
    return true;
  std::vector<std::string> titles;  // `time_s,acc_g` is a plain table
  for (const CsvCell& cell : cells) titles.emplace_back(cell.text);
  return titles[0] == "time_s" &&
         std::ranges::none_of(parsed_titles(titles), &ColumnTitle::is_acceleration);
}

/// @throws Error for unknown, doubled or missing columns, rows of another length, what is no
///         number, times that are not evenly spaced, a file that ends within a row,
///         and azimuths or starts that cannot be read.
std::vector<Component> read_columns_csv(const SourceFile& file, const ReadOptions& options) {
  LayoutReader in(file, options);
  FileErrors& errors = in.errors;
  const std::size_t head = header_line(file);
  const auto columns = columns_of(file, head, errors);
  if (!file.ends_with_line_end())
    errors.add(file.lines().size(), file.lines().back().size(),
               "the last line has no line end: the file seems to be cut");

  std::vector<std::vector<double>> values(columns.size() + 1);
  std::vector<std::size_t> lines;
  for (std::size_t i = head + 1; i < file.lines().size(); ++i) {
    if (!is_content(file.lines()[i])) continue;
    const auto cells = csv_row(file.lines()[i]);
    if (cells.size() != values.size()) {
      errors.add(i + 1, 1,
                 fmt::format("{} columns, the header has {}", cells.size(), values.size()));
      continue;
    }
    lines.push_back(i + 1);
    for (std::size_t k = 0; k < cells.size(); ++k) {
      const auto value = number(cells[k].text);
      if (!value)
        errors.add(i + 1, cells[k].column,
                   fmt::format("'{}' is not a finite number", cells[k].text.substr(0, 40)));
      values[k].push_back(value.value_or(0));
    }
  }
  in.check_enough(static_cast<double>(lines.size()), 0);
  errors.throw_if_any();
  const double step = even_step(values[0], lines, errors);
  check_options(options, step, errors);
  errors.throw_if_any();

  std::vector<Component> components;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    Component component = component_of(values[k + 1], {columns[k]->unit, columns[k]->to_si}, step);
    component.name = columns[k]->name;
    component.direction = columns[k]->direction;
    if (const auto late = late_start(values[0][0], step); k == 0 && !late.empty())
      component.warnings.push_back(late);
    components.push_back(std::move(component));
  }
  read_columns_csv_facts(file, head, components, errors);
  errors.throw_if_any();
  return components;
}

std::string columns_csv_text(const Record& record, const std::vector<std::string>& comments,
                             int digits) {
  constexpr std::array kAxes = {"x", "y", "z"};
  std::string text;
  for (const std::string& comment : comments)
    text += comment.empty() ? "#\n" : "# " + comment + "\n";
  text += columns_csv_facts(record);
  text += "time_s";
  for (const Direction direction : kDirections)
    if (record[direction])
      text += fmt::format(",{}_m_per_s2", kAxes[static_cast<std::size_t>(direction)]);
  text += "\n";
  for (Eigen::Index i = 0; i < record.samples(); ++i) {
    text += fmt::format("{:.10g}", static_cast<double>(i) * record.time_step());
    for (const auto& component : record.components)
      if (component) text += fmt::format(",{:.{}f}", component->acceleration[i], digits);
    text += "\n";
  }
  return text;
}

std::string columns_csv_facts(const Record& record) {
  std::string text;
  for (const Direction direction : kDirections) {
    const auto& component = record[direction];
    if (component && component->azimuth && direction != Direction::kVertical)
      text += fmt::format("# {}: {}{:.10g}{}\n", name_of(direction), kAzimuth,
                          *component->azimuth / kRadiansPerDegree, kDegrees);
    if (component && component->start_time)
      text +=
          fmt::format("# {}: {}{}\n", name_of(direction), kStart, utc_text(*component->start_time));
  }
  return text;
}

void read_columns_csv_facts(const SourceFile& file, std::size_t head,
                            std::vector<Component>& components, FileErrors& errors) {
  for (std::size_t i = 0; i < head; ++i) {
    std::string_view line = trimmed(file.lines()[i]);
    if (line.empty()) continue;
    line = trimmed(line.substr(1));
    const auto colon = std::min(line.find(':'), line.size());
    const std::string_view place = line.substr(0, colon);
    const std::string_view fact = trimmed(line.substr(std::min(colon + 1, line.size())));
    if (!is_one_of(place, "h1 h2 vertical a")) continue;
    if (!fact.starts_with(kAzimuth) && !fact.starts_with(kStart)) continue;
    const auto at = std::ranges::find(components, place, place_of);
    const std::string wrong = at == components.end()
                                  ? fmt::format("the file has no column of {}", place)
                                  : read_fact(fact, *at);
    if (!wrong.empty()) errors.add(i + 1, 1, wrong);
  }
}

}  // namespace gurney::groundmotions
