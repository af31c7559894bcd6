#include "groundmotions/buildings/floor_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "engine/base/error.h"
#include "engine/config/nearest_name.h"
#include "groundmotions/formats/event_file.h"
#include "groundmotions/formats/plain_rows.h"
#include "groundmotions/formats/source_file.h"
#include "groundmotions/formats/time_column.h"
#include "groundmotions/record/acceleration_unit.h"

namespace gurney::groundmotions {
namespace {

using config::Range;
using config::Table;

constexpr const char *kRecord = "{record}", *kFloor = "{floor}", *kDirection = "{direction}";
constexpr int kPrintedDigits =
    6;  ///< significant ones of a recorder of OpenSees, where nothing else is stated

bool has(const std::string& text, const char* mark) { return text.find(mark) != std::string::npos; }

std::string replaced(std::string text, const std::string& mark, const std::string& name) {
  for (std::size_t at = text.find(mark); at != std::string::npos;
       at = text.find(mark, at + name.size()))
    text.replace(at, mark.size(), name);
  return text;
}

/// Parts of "time, 1 h1, 1 h2".
std::vector<std::string> parts_of(const std::string& text) {
  std::vector<std::string> parts;
  for (std::string_view rest = text;;) {
    const std::size_t comma = rest.find(',');
    std::string_view part = rest.substr(0, comma);
    while (part.starts_with(' ')) part.remove_prefix(1);
    while (part.ends_with(' ')) part.remove_suffix(1);
    parts.emplace_back(part);
    if (comma == std::string_view::npos) return parts;
    rest.remove_prefix(comma + 1);
  }
}

/// Meaning of a column: "time", "skip", or a floor and a direction, without those in the path.
FloorTables::Column column_of(const std::string& text, const FloorTables& tables) {
  if (text == "time") return {.is_time = true};
  if (text == "skip") return {};
  const bool of_floor = !has(tables.pattern, kFloor),
             of_direction = !has(tables.pattern, kDirection);
  FloorTables::Column column;
  std::string floor = text;
  if (of_direction) {
    const std::size_t blank = text.rfind(' ');
    const std::string name = text.substr(blank + 1);
    floor = blank == std::string::npos ? "" : text.substr(0, blank);
    std::vector<std::string> known;
    for (const Direction direction : kDirections) {
      known.push_back(tables.directions[static_cast<std::size_t>(direction)]);
      if (!name.empty() && name == known.back()) column.direction = direction;
    }
    require(column.direction.has_value(),
            fmt::format("'{}' is no direction; known: {}", name, fmt::join(known, ", ")));
  }
  if (of_floor) {
    const auto found = std::ranges::find(tables.floors, floor);
    require(found != tables.floors.end(),
            fmt::format("'{}' is no floor{}", floor, config::suggestion(floor, tables.floors)));
    column.floor = static_cast<std::size_t>(found - tables.floors.begin());
  } else if (of_direction) {
    require(floor.empty(), fmt::format("the floor is in the name of the file: must be a direction "
                                       "alone, 'time' or 'skip'"));
  } else {
    require(floor == "acceleration",
            "must be time, skip or acceleration: floor and direction are in "
            "the name of the file");
  }
  return column;
}

std::vector<FloorTables::Column> columns_of(const FloorTables& tables) {
  std::vector<FloorTables::Column> columns;
  for (const std::string& text : tables.columns) columns.push_back(column_of(text, tables));
  return columns;
}

void check_columns(Table& table, const FloorTables& tables) {
  bool time = false, any = false;
  std::map<std::string, int> seen;
  for (const std::string& text : tables.columns) {
    if (text != "skip" && ++seen[text] == 2)
      table.note("columns", fmt::format(": has '{}' twice", text));
    try {
      const FloorTables::Column column = column_of(text, tables);
      time = time || column.is_time;
      any = any || (!column.is_time && text != "skip");
    } catch (const Error& error) {
      table.note("columns", fmt::format(": \"{}\": {}", text, error.what()));
      any = true;
    }
  }
  if (!any) table.note("columns", ": must have an acceleration");
  if (time == tables.time_step.has_value())
    table.note("columns",
               time ? ": has a time, so that time_step_s must not be given"
                    : ": has no time; time_step_s is needed, and the first row is at 0 s");
  if (tables.relative && !time)
    table.note("columns", ": must have a time where accelerations are relative to the ground's");
}

/// One file: times, and the accelerations of the floor by direction, in the file's unit.
struct FloorSeries {
  double time_step = 0, first_time = 0;
  std::array<std::optional<std::vector<double>>, 3> samples;
  std::array<std::pair<std::string, std::string>, 3> files;  ///< name and SHA-256
};

/// Shortest decimal number for a step of printed times.
double plain_step(double mean, std::size_t steps, double rounding) {
  for (int digits = 1; digits < kPrintedDigits; ++digits) {
    const double scale = std::pow(10, digits - 1 - std::floor(std::log10(mean)));
    const double plain = std::round(mean * scale) / scale;
    if (std::abs(plain - mean) * static_cast<double>(steps) <= rounding) return plain;
  }
  return mean;
}

/// Largest error of a time of this size that is printed with kPrintedDigits [s].
double rounding_of(double time) {
  return time > 0 ? 0.5 * std::pow(10, std::floor(std::log10(time)) + 1 - kPrintedDigits) : 0;
}

void read_times(const std::vector<double>& times, const std::vector<std::size_t>& lines,
                FloorSeries& series, FileErrors& errors) {
  const double rounding = rounding_of(times.back());
  const double mean = even_step(times, lines, errors, 2 * rounding);
  errors.throw_if_any();
  series.time_step = plain_step(mean, times.size() - 1, 2 * rounding);
  const double late = times.front() / series.time_step;
  const double allowed = kTimeTolerance + rounding_of(times.front()) / series.time_step;
  if (!(std::abs(late) <= allowed || std::abs(late - 1) <= allowed))
    errors.add(
        lines.front(), 1,
        fmt::format("the first time is {} s: must be 0 or one step, {:.6g} s, of the clock on "
                    "which the ground motion begins at 0 s",
                    times.front(), series.time_step));
  series.first_time = std::round(late) * series.time_step;
}

void read_columns(const SourceFile& file, const FloorTables& tables, std::size_t floor,
                  std::optional<Direction> of_file, FloorSeries& series) {
  FileErrors errors(file);
  const PlainRows rows = plain_rows(file, errors);
  errors.throw_if_any();
  const std::vector<FloorTables::Column> columns = columns_of(tables);
  for (std::size_t i = 0; i < rows.lengths.size(); ++i)
    if (rows.lengths[i] != columns.size()) {
      errors.add(
          rows.lines[i], 1,
          fmt::format("has {} numbers; `columns` names {}", rows.lengths[i], columns.size()));
      break;
    }
  if (rows.lengths.size() < 2) errors.add(1, 1, "must have two rows of numbers at least");
  errors.throw_if_any();
  const auto column = [&](std::size_t i) {
    std::vector<double> values(rows.lengths.size());
    for (std::size_t row = 0; row < values.size(); ++row)
      values[row] = rows.values[row * columns.size() + i];
    return values;
  };
  if (tables.time_step) series.time_step = *tables.time_step;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i].is_time) {
      read_times(column(i), rows.lines, series, errors);
      continue;
    }
    if (tables.columns[i] == "skip" || columns[i].floor.value_or(floor) != floor) continue;
    const Direction direction = of_file ? *of_file : *columns[i].direction;
    series.samples[static_cast<std::size_t>(direction)] = column(i);
  }
  errors.throw_if_any();
}

void read_series(const SourceFile& file, const FloorTables& tables, std::size_t floor,
                 std::optional<Direction> of_file, FloorSeries& found) {
  const std::map<std::string, EventSeries> known = event_series(file);
  std::vector<std::string> names;
  for (const auto& each : known) names.push_back(each.first);
  for (const Direction direction : kDirections) {
    const std::string& own = tables.directions[static_cast<std::size_t>(direction)];
    if (own.empty() || (of_file && *of_file != direction)) continue;
    const std::string name =
        replaced(replaced(tables.series, kFloor, tables.floors[floor]), kDirection, own);
    const auto series = known.find(name);
    require(series != known.end(), fmt::format("{}: no time series '{}'{}", file.name(), name,
                                               config::suggestion(name, names)));
    const double step = series->second.time_step;
    require(found.time_step == 0 || step == found.time_step,
            fmt::format("{}: time series '{}' has dT = {:g}, the one before {:g}: must be the same",
                        file.name(), name, step, found.time_step));
    found.time_step = step;
    found.samples[static_cast<std::size_t>(direction)] = series->second.samples;
  }
}

/// Files of one floor under one ground motion; of_file: the direction that its name states.
FloorSeries read_floor(const Record& ground, const FloorTables& tables, std::size_t floor) {
  std::vector<std::optional<Direction>> of_files = {{}};
  if (has(tables.pattern, kDirection)) {
    of_files.clear();
    for (const Direction direction : kDirections)
      if (!tables.directions[static_cast<std::size_t>(direction)].empty())
        of_files.emplace_back(direction);
  }
  FloorSeries all;
  for (const std::optional<Direction>& direction : of_files) {
    std::string path = replaced(tables.pattern, kRecord, ground.name);
    path = replaced(path, kFloor, tables.floors[floor]);
    if (direction)
      path = replaced(path, kDirection, tables.directions[static_cast<std::size_t>(*direction)]);
    require(std::filesystem::exists(path),
            fmt::format("{}: no such file: {}: floor '{}' under the ground motion '{}'",
                        tables.where, path, tables.floors[floor], ground.name));
    const SourceFile file(path);
    FloorSeries one;
    if (tables.columns.empty())
      read_series(file, tables, floor, direction, one);
    else
      read_columns(file, tables, floor, direction, one);
    if (all.time_step > 0)
      require(
          one.time_step == all.time_step && one.first_time == all.first_time,
          fmt::format("{}: begins at {:g} s with steps of {:g} s; the table before at {:g} s with "
                      "steps of {:g} s: must be the same",
                      path, one.first_time, one.time_step, all.first_time, all.time_step));
    all.time_step = one.time_step;
    all.first_time = one.first_time;
    for (std::size_t i = 0; i < 3; ++i) {
      if (!one.samples[i]) continue;
      all.samples[i] = std::move(one.samples[i]);
      all.files[i] = {path, file.sha256()};
    }
  }
  std::size_t rows = 0;
  for (const auto& samples : all.samples) {
    if (!samples) continue;
    require(rows == 0 || samples->size() == rows,
            fmt::format("{}: floor '{}' under '{}' has {} and {} samples: must be as many",
                        tables.where, tables.floors[floor], ground.name, rows, samples->size()));
    rows = samples->size();
  }
  require(rows > 0,
          fmt::format("{}: no column for floor '{}'", tables.where, tables.floors[floor]));
  return all;
}

/// Acceleration of the ground at a time: linear between its samples, 0 after the last [m/s2].
double ground_at(const Component& ground, double time) {
  const double place = time / ground.time_step;
  const auto last = ground.acceleration.size() - 1;
  const auto i = static_cast<Eigen::Index>(place);
  if (i >= last)
    return i == last && place <= static_cast<double>(last) + kTimeTolerance
               ? ground.acceleration[last]
               : 0;
  const double share = place - static_cast<double>(i);
  return (1 - share) * ground.acceleration[i] + share * ground.acceleration[i + 1];
}

/// Factor on the tables: the ground's now over that with which they were computed.
double factor_of(const Record& ground, const FloorTables& tables, Direction direction) {
  const Component* component = nullptr;
  for (const Direction each : {Direction::kVertical, Direction::kH2, Direction::kH1, direction})
    if (ground[each]) component = &*ground[each];
  const double factor = component->scale / tables.ground_scale;
  require(
      tables.proportional || std::abs(factor - 1) < 1e-9,
      fmt::format("{}: the tables are of ground motions times {:g}; '{}' is scaled by {:g}: only "
                  "floors that move in proportion to the ground (`proportional = true`) can follow",
                  tables.where, tables.ground_scale, ground.name, component->scale));
  return std::abs(factor - 1) < 1e-9 ? 1 : factor;
}

}  // namespace

FloorTables read_floor_tables(Table& table) {
  FloorTables tables;
  const std::size_t before = table.document().errors();
  tables.floors = table.texts("floors");
  if (tables.floors.empty() && table.document().errors() == before)
    table.note("floors", ": missing; must name the floors, the lowest first");
  for (std::size_t i = 0; i < tables.floors.size(); ++i)
    if (std::ranges::count(tables.floors, tables.floors[i]) > 1 || tables.floors[i].empty())
      table.note("floors", fmt::format(": \"{}\": must be names that differ", tables.floors[i]));
  tables.where = table.where("file");
  const std::string pattern = table.text("file");
  tables.pattern = (std::filesystem::path(table.document().path()).parent_path() / pattern)
                       .lexically_normal()
                       .string();
  std::vector<std::string> directions = table.texts("directions");
  if (directions.empty()) {
    for (const Direction direction : kDirections) directions.emplace_back(name_of(direction));
    if (has(pattern, kDirection))
      table.note("directions", ": missing; must name h1, h2, vertical in the names of the files");
  }
  if (directions.size() > 3) table.note("directions", ": must be at most three: h1, h2, vertical");
  directions.resize(3);
  std::ranges::copy(directions, tables.directions.begin());
  const std::vector<std::string>& units = acceleration_unit_names();
  tables.unit = units[table.choice("unit", units)];
  tables.relative = table.choice("acceleration", {"absolute", "relative"}) == 1;
  tables.proportional = table.boolean("proportional", false);
  tables.ground_scale = table.number("ground_scale", Range::positive(), 1.0);
  if (table.has("time_step_s"))
    tables.time_step =
        table.number("time_step_s", Range::within(kShortestTimeStep, kLongestTimeStep));
  tables.series = table.text("series", "");
  const std::vector<std::string> columns = table.texts("columns");
  if (tables.series.empty() == columns.empty()) {
    table.note("columns", ": must have `columns` (of a table of numbers) or `series` (of JSON)");
    return tables;
  }
  for (const std::string& text : columns)
    for (std::string& part : parts_of(text)) tables.columns.push_back(std::move(part));
  if (!tables.columns.empty()) {
    if (table.document().errors() == before) check_columns(table, tables);
    return tables;
  }
  if (tables.time_step)
    table.note("time_step_s", ": must not be given with series, which have a dT");
  for (const char* mark : {kFloor, kDirection})
    if (!has(pattern + tables.series, mark))
      table.note("series",
                 fmt::format(" = \"{}\": must have {} here or in `file`", tables.series, mark));
  return tables;
}

Record floor_from_tables(const Record& ground, const FloorTables& tables, std::size_t floor) {
  FloorSeries series = read_floor(ground, tables, floor);
  const double unit = acceleration_unit(tables.unit)->to_si;
  const double step = series.time_step;
  const auto lead = static_cast<Eigen::Index>(std::round(series.first_time / step));
  Eigen::Index samples = 0;
  for (const auto& each : series.samples)
    if (each) samples = lead + static_cast<Eigen::Index>(each->size());
  Record record = ground;
  for (const Direction direction : kDirections) {
    const auto i = static_cast<std::size_t>(direction);
    auto& component = record.components[i];
    if (!series.samples[i]) {
      if (!component) continue;
      const Component below = *component;
      component->time_step = step;
      component->acceleration.resize(samples);
      for (Eigen::Index k = 0; k < samples; ++k)
        component->acceleration[k] = ground_at(below, static_cast<double>(k) * step);
      record.processing.push_back(
          fmt::format("{}: the tables have none: as the ground", name_of(direction)));
      continue;
    }
    require(
        !tables.relative || component,
        fmt::format("{}: relative accelerations along {} need that component of the ground motion "
                    "'{}', which has none",
                    tables.where, name_of(direction), ground.name));
    const double factor = unit * factor_of(ground, tables, direction);
    Eigen::VectorXd acceleration =
        Eigen::VectorXd::Zero(samples);  // the building is at rest before
    acceleration.tail(samples - lead) =
        factor * Eigen::Map<const Eigen::VectorXd>(series.samples[i]->data(), samples - lead);
    if (tables.relative)
      for (Eigen::Index k = lead; k < samples; ++k)
        acceleration[k] += ground_at(*component, static_cast<double>(k) * step);
    if (!component) component.emplace();
    component->name = fmt::format("floor {}", tables.floors[floor]);
    component->direction = direction;
    component->time_step = step;
    component->acceleration = std::move(acceleration);
    record.floor_files.push_back(series.files[i]);
  }
  const double end = static_cast<double>(samples - 1) * step;
  const double below = ground.time_step() * static_cast<double>(ground.samples() - 1);
  record.processing.push_back(fmt::format(
      "floor '{}' from tables of another program: {} s, samples every {:g} s, {} accelerations in "
      "{}",
      tables.floors[floor], end, step, tables.relative ? "relative" : "absolute", tables.unit));
  if (end < below - step)
    record.warnings.push_back(
        fmt::format("floor '{}': its table ends at {:g} s, the ground motion at {:g} s: the floor "
                    "stands still then",
                    tables.floors[floor], end, below));
  return record;
}

}  // namespace gurney::groundmotions
