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

bool first_column_grows(const PlainRows& rows, std::size_t width) {
  for (std::size_t i = width; i < rows.values.size(); i += width)
    if (!(rows.values[i] > rows.values[i - width])) return false;
  return rows.lengths.size() > 2;
}

}  // namespace

PlainColumns plain_columns(const PlainRows& rows, bool stated, const ReadOptions& options,
                           FileErrors& errors) {
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
  } else if (even && first_column_grows(rows, width)) {
    result.columns.resize(width);
    result.columns[0].kind = Kind::kTime;
  } else if (!even && odd + 1 == rows.lengths.size() && first_column_grows(rows, width)) {
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
