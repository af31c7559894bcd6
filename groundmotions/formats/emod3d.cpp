#include <fmt/format.h>

#include <cmath>

#include "groundmotions/formats/numbers.h"
#include "groundmotions/formats/orientation.h"
#include "groundmotions/formats/readers.h"
#include "groundmotions/formats/stated.h"
#include "groundmotions/formats/words.h"

namespace gurney::groundmotions {

namespace {

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
  FileErrors errors(file);
  const auto words = words_of(file.lines()[0], kBlanks);
  const auto head = numbers_of(file.lines()[1]);
  Component component;
  component.time_step = checked_time_step(head[1], "dt", 2, options, errors);
  const AccelerationUnit unit = agreed_unit({}, 0, options, errors);
  component.unit = unit.name;
  NumberReader reader(file, errors);
  read_to_end(file, 2, reader);
  if (!errors.any()) check_count(head[0], "npts", 2, reader.values().size(), errors);
  errors.throw_if_any();

  component.acceleration = scaled(reader.values(), unit.to_si);
  component.name = words[1];
  orient(component.name, component);
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
