#include "groundmotions/formats/plain_columns.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/config/nearest_name.h"
#include "groundmotions/formats/numbers.h"

namespace gurney::groundmotions {

namespace {

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

}  // namespace

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

}  // namespace gurney::groundmotions
