#include "groundmotions/formats/bbp.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "groundmotions/formats/numbers.h"
#include "groundmotions/formats/orientation.h"
#include "groundmotions/formats/stated.h"
#include "groundmotions/formats/time_column.h"
#include "groundmotions/formats/unit_text.h"
#include "groundmotions/formats/words.h"

namespace gurney {

namespace {

constexpr auto kNone = std::string_view::npos;

/// What the comments state.
struct Header {
  std::size_t lines = 0;      ///< of comments at the top
  std::string_view unit;      ///< empty: not stated
  std::size_t unit_line = 1;  ///< from 1
  std::array<std::string, 3> names = {"N-S", "E-W", "U-D"};
  bool names_columns = false;  ///< a comment speaks of the columns
  std::vector<std::pair<std::string_view, std::string_view>> facts;
};

bool is_comment(std::string_view line) {
  line = trimmed(line);
  return !line.empty() && (line[0] == '#' || line[0] == '%');
}

/// `N-S(cm/s/s)  E-W(cm/s/s)  U-D(cm/s/s)`
void take_names(std::string_view rest, Header& header) {
  for (std::string& name : header.names) {
    const auto open = rest.find('('), close = rest.find(')');
    if (open == kNone || close == kNone || trimmed(rest.substr(0, open)).empty()) return;
    name = trimmed(rest.substr(0, open));
    rest.remove_prefix(close + 1);
  }
}

/// `orientation= 0.0,90.0,up`
void take_orientation(std::string_view value, Header& header) {
  for (std::string& name : header.names) {
    const auto end = std::min(value.find(','), value.size());
    name = trimmed(value.substr(0, end));
    value.remove_prefix(std::min(end + 1, value.size()));
  }
}

void take_comment(std::string_view comment, std::size_t line, Header& header) {
  const std::string text = lower(comment);
  const auto state_unit = [&](std::string_view unit) {
    if (!header.unit.empty() || unit.empty()) return;
    header.unit = unit;
    header.unit_line = line;
  };
  if (const auto time = text.find("time(sec)"); time != kNone) {
    header.names_columns = true;
    const auto rest = comment.substr(time + std::string_view("time(sec)").size());
    state_unit(in_brackets(rest));
    take_names(rest, header);
  } else if (text.find("column 1: time") != kNone) {
    header.names_columns = true;
  } else if (text.find("column 2:") != kNone) {
    const auto unit = in_brackets(comment);
    if (acceleration_unit(unit) || other_quantity(unit)) state_unit(unit);
  }
  const auto sign = comment.find_first_of(":=");
  if (sign == kNone) return;
  const auto key = trimmed(comment.substr(0, sign)), value = trimmed(comment.substr(sign + 1));
  if (lower(key) == "units") state_unit(value.substr(0, value.find_first_of(" ,;")));
  if (lower(key) == "orientation") {
    header.names_columns = true;
    take_orientation(value, header);
  }
  if (!key.empty() && !value.empty() && !text.starts_with("column"))
    header.facts.emplace_back(key, value);
}

Header header_of(const SourceFile& file) {
  Header header;
  for (const std::string_view line : file.lines()) {
    if (!is_comment(line) && !trimmed(line).empty()) break;
    ++header.lines;
    auto comment = trimmed(line);
    comment.remove_prefix(std::min(comment.find_first_not_of("#% \t"), comment.size()));
    take_comment(comment, header.lines, header);
  }
  return header;
}

void warn_of_copies(std::vector<Component>& components) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = i + 1; k < 3; ++k)
      if (components[i].acceleration == components[k].acceleration &&
          !components[i].acceleration.isZero(0))
        components[k].warnings.push_back(fmt::format(
            "component {} has exactly the samples of {}: one of them seems to be a copy",
            components[k].name, components[i].name));
}

}  // namespace

bool recognises_bbp(const SourceFile& file) {
  return is_comment(file.lines().front()) && header_of(file).names_columns;
}

std::vector<Component> read_bbp(const SourceFile& file, const ReadOptions& options) {
  Mistakes mistakes(file.name());
  const Header header = header_of(file);
  if (const auto quantity = other_quantity(header.unit)) {
    mistakes.add(header.unit_line, 1,
                 fmt::format("a record must be acceleration, but this is a {} file ({}); take the "
                             ".acc.bbp file of this station",
                             *quantity, header.unit));
    mistakes.throw_if_any();
  }
  const AccelerationUnit unit =
      header.unit.empty() ? agreed_unit({}, 0, options, mistakes)
                          : checked_unit(header.unit, header.unit_line, options, mistakes);

  NumberReader reader(file, mistakes);
  std::vector<std::size_t> lines;
  for (std::size_t i = header.lines; i < file.lines().size(); ++i) {
    if (is_comment(file.lines()[i]) || trimmed(file.lines()[i]).empty()) continue;
    lines.push_back(i + 1);
    if (const auto count = reader.read_line(i); count != 4)
      mistakes.add(i + 1, 1,
                   fmt::format("{} numbers on a line, time and three components are 4", count));
  }
  reader.check_end();
  if (lines.size() < 2)
    mistakes.add(fmt::format("{} samples are no record (2 at least)", lines.size()));
  mistakes.throw_if_any();

  std::array<std::vector<double>, 4> columns;
  for (std::size_t i = 0; i < reader.values().size(); ++i)
    columns[i % 4].push_back(reader.values()[i]);
  const double step = even_step(columns[0], lines, mistakes);
  checked_time_step(step, "the time step", lines[0], options, mistakes);
  mistakes.throw_if_any();

  std::vector<Component> components(3);
  for (std::size_t k = 0; k < 3; ++k) {
    Component& component = components[k];
    component.name = header.names[k];
    component.time_step = step;
    component.unit = unit.name;
    component.acceleration = scaled(columns[k + 1], unit.to_si);
    component.header.insert(component.header.end(), header.facts.begin(), header.facts.end());
    orient(component.name, component);
  }
  if (const auto late = late_start(columns[0][0], step); !late.empty())
    components[0].warnings.push_back(late);
  warn_of_copies(components);
  return components;
}

}  // namespace gurney
