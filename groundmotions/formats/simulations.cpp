// Text files of programs that simulate ground motions.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "groundmotions/formats/numbers.h"
#include "groundmotions/formats/orientation.h"
#include "groundmotions/formats/readers.h"
#include "groundmotions/formats/stated.h"
#include "groundmotions/formats/time_column.h"
#include "groundmotions/formats/words.h"

namespace gurney::groundmotions {

namespace {

// --- SCEC Broadband Platform

/// Statements of the comments.
struct BbpHeader {
  std::size_t lines = 0;            ///< of comments at the top
  std::string_view unit;            ///< empty: not stated
  std::size_t unit_line = 1;        ///< from 1
  std::size_t other_unit_line = 0;  ///< of a column that states another; 0: none
  std::string_view time_unit;       ///< empty: not stated
  std::size_t time_line = 1;
  std::array<std::string, 3> names = {"N-S", "E-W", "U-D"};
  std::array<bool, 3> is_negative = {};  ///< (+ is southward), westward, downward
  bool names_columns = false;            ///< a comment speaks of the columns
  bool has_orientation = false;          ///< which overrides what the columns state
  std::vector<std::pair<std::string_view, std::string_view>> facts;
};

bool is_comment(std::string_view line) {
  line = trimmed(line);
  return !line.empty() && (line[0] == '#' || line[0] == '%');
}

/// `N-S(cm/s/s)  E-W(cm/s/s)  U-D(cm/s/s)`
void take_names(std::string_view rest, BbpHeader& header) {
  for (std::string& name : header.names) {
    const auto open = rest.find('('), close = rest.find(')');
    if (open == kNone || close == kNone || trimmed(rest.substr(0, open)).empty()) return;
    name = trimmed(rest.substr(0, open));
    rest.remove_prefix(close + 1);
  }
}

/// `orientation= 0.0,90.0,up`
void take_orientation(std::string_view value, BbpHeader& header) {
  for (std::string& name : header.names) {
    const auto end = std::min(value.find(','), value.size());
    name = trimmed(value.substr(0, end));
    value.remove_prefix(std::min(end + 1, value.size()));
  }
}

/// `Column 2: North-south acceleration (cm/s/s) (+ is northward)`
/// @param column  0 for the first component
void take_column(std::string_view text, std::size_t column, BbpHeader& header) {
  constexpr std::array<std::array<std::string_view, 4>, 3> kAxes = {
      {{"north-south", "n-s", "north", "N-S"},
       {"east-west", "e-w", "east", "E-W"},
       {"up-down", "u-d", "vert", "U-D"}}};
  const std::string line = lower(text);
  const auto sense = line.find("(+ is ");
  const std::string_view axis = std::string_view(line).substr(0, sense);
  for (const auto& [name, code, start, plain] : kAxes)
    if (!header.has_orientation &&
        (axis.find(name) != kNone || axis.starts_with(code) || axis.starts_with(start)))
      header.names[column] = plain;
  if (sense == kNone) return;
  const auto towards = std::string_view(line).substr(sense + 6);
  const std::pair<std::string_view, std::string_view> kSenses[] = {
      {"north", "N-S"}, {"south", "N-S"}, {"east", "E-W"},
      {"west", "E-W"},  {"up", "U-D"},    {"down", "U-D"}};
  for (const auto& [word, name] : kSenses) {
    if (!towards.starts_with(word)) continue;
    if (!header.has_orientation) header.names[column] = name;
    header.is_negative[column] = word == "south" || word == "west" || word == "down";
  }
}

void take_comment(std::string_view comment, std::size_t line, BbpHeader& header) {
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
    header.time_unit = in_brackets(comment);
    header.time_line = line;
  } else if (const auto at = text.find("column "); at != kNone && text.substr(at + 8, 1) == ":" &&
                                                   text[at + 7] >= '2' && text[at + 7] <= '4') {
    const auto rest = trimmed(comment.substr(at + 9));
    take_column(rest, static_cast<std::size_t>(text[at + 7] - '2'), header);
    const auto unit = in_brackets(rest);
    if (acceleration_unit(unit) || other_quantity(unit)) {
      if (header.unit.empty() || plain_unit(header.unit) == plain_unit(unit))
        state_unit(unit);
      else
        header.other_unit_line = line;
    }
  }
  const auto sign = comment.find_first_of(":=");
  if (sign == kNone) return;
  const auto key = trimmed(comment.substr(0, sign)), value = trimmed(comment.substr(sign + 1));
  if (lower(key) == "units") state_unit(value.substr(0, value.find_first_of(" ,;")));
  if (lower(key) == "orientation") {
    header.names_columns = true;
    header.has_orientation = true;
    take_orientation(value, header);
  }
  if (!key.empty() && !value.empty() && !text.starts_with("column"))
    header.facts.emplace_back(key, value);
}

BbpHeader bbp_header(const SourceFile& file) {
  BbpHeader header;
  for (const std::string_view line : file.lines()) {
    if (!is_comment(line) && !trimmed(line).empty()) break;
    ++header.lines;
    take_comment(left_trimmed(trimmed(line), "#% \t"), header.lines, header);
  }
  return header;
}

/// Turns what is positive to the south, west or down.
void turn(bool is_negative, Component& component) {
  if (!is_negative) return;
  component.acceleration = -component.acceleration;
  component.warnings.push_back(fmt::format(
      "the comments say that + is to the south, west or down in {}: its sign was turned",
      component.name));
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

// --- EMOD3D and ucgmsim

constexpr std::string_view kBlanks = " \t\v\f\x1a";

/// The numbers of a line; empty if it holds anything else.
std::vector<double> numbers_of(std::string_view line) {
  std::vector<double> values;
  for (const auto word : words_of(line, kBlanks)) {
    const auto value = number(word);
    if (!value) return {};
    values.push_back(*value);
  }
  return values;
}

}  // namespace

bool recognises_bbp(const SourceFile& file) {
  return is_comment(file.lines().front()) && bbp_header(file).names_columns;
}

/// @throws Error for velocities and displacements, missing units, rows of another length, what is
///         no number and times that are not evenly spaced.
std::vector<Component> read_bbp(const SourceFile& file, const ReadOptions& options) {
  LayoutReader in(file, options);
  const BbpHeader header = bbp_header(file);
  if (const auto quantity = other_quantity(header.unit))
    in.refuse(header.unit_line,
              fmt::format("a record must be acceleration, but this is a {} file ({}); take the "
                          ".acc.bbp file of this station",
                          *quantity, header.unit));
  const auto seconds = header.time_unit.empty() ? std::optional(1.0) : time_unit(header.time_unit);
  if (!seconds)
    in.error(
        header.time_line,
        fmt::format("'{}' is not a unit of time: s, ms, us or min are allowed", header.time_unit));
  if (header.other_unit_line > 0)
    in.error(header.other_unit_line,
             fmt::format("this column has another unit than line {}; one unit is allowed",
                         in.errors.line_in_file(header.unit_line)));
  const auto& names = header.names;
  if (names[0] == names[1] || names[1] == names[2] || names[0] == names[2])
    in.error(1, fmt::format("the comments name the columns {}, {} and {}: one is named twice",
                            names[0], names[1], names[2]));
  const AccelerationUnit unit =
      header.unit.empty() ? in.agreed_unit({}, 0) : in.checked_unit(header.unit, header.unit_line);

  NumberReader reader(file, in.errors);
  std::vector<std::size_t> lines;
  for (std::size_t i = header.lines; i < file.lines().size(); ++i) {
    if (is_comment(file.lines()[i]) || is_blank(file.lines()[i])) continue;
    lines.push_back(i + 1);
    if (const auto count = reader.read_line(i); count != 4)
      in.error(i + 1, fmt::format("{} numbers on a line, time and three components are 4", count));
  }
  reader.check_end();
  in.check_enough(static_cast<double>(lines.size()), 0);
  in.errors.throw_if_any();

  std::array<std::vector<double>, 4> columns;
  for (std::size_t i = 0; i < reader.values().size(); ++i)
    columns[i % 4].push_back(reader.values()[i]);
  for (double& time : columns[0]) time *= *seconds;
  const double step = even_step(columns[0], lines, in.errors);
  in.checked_time_step({step, "the time step", lines[0]});
  in.errors.throw_if_any();

  std::vector<Component> components;
  for (std::size_t k = 0; k < 3; ++k) {
    components.push_back(component_of(columns[k + 1], unit, step));
    components[k].header.assign(header.facts.begin(), header.facts.end());
    name_and_orient(names[k], components[k]);
    turn(header.is_negative[k], components[k]);
  }
  if (const auto late = late_start(columns[0][0], step); !late.empty())
    components[0].warnings.push_back(late);
  warn_of_copies(components);
  return components;
}

bool recognises_emod3d(const SourceFile& file) {
  if (file.lines().size() < 3 || !numbers_of(file.lines()[0]).empty() ||
      words_of(file.lines()[0], kBlanks).size() < 2)
    return false;
  const auto head = numbers_of(file.lines()[1]);
  const auto is_whole = [](double value) { return value == std::floor(value); };
  return head.size() == 8 && head[0] >= 2 && is_whole(head[0]) && head[1] > 0 &&
         is_whole(head[2]) && is_whole(head[3]) && std::abs(head[2]) < 24 && std::abs(head[3]) < 60;
}

/// @throws Error without options.unit, for a wrong header and a count that does not match.
std::vector<Component> read_emod3d(const SourceFile& file, const ReadOptions& options) {
  LayoutReader in(file, options);
  const auto words = words_of(file.lines()[0], kBlanks);
  const auto head = numbers_of(file.lines()[1]);
  const double time_step = in.checked_time_step({head[1], "dt", 2});
  Component component = in.read_to_end(2, in.agreed_unit({}, 0), time_step, {head[0], "npts", 2});
  name_and_orient(words[1], component);
  component.header.emplace_back("station", words[0]);
  if (words.size() > 2)
    component.header.emplace_back("title", trimmed(file.lines()[0].substr(static_cast<std::size_t>(
                                               words[2].data() - file.lines()[0].data()))));
  component.header.emplace_back("first sample after the origin [s]",
                                fmt::format("{}", (head[2] * 60 + head[3]) * 60 + head[4]));
  component.header.emplace_back("distance [km]", fmt::format("{}", head[5]));
  return {component};
}

}  // namespace gurney::groundmotions
