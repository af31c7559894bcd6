#include "groundmotions/formats/plain_facts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "groundmotions/formats/header_text.h"
#include "groundmotions/formats/unit_text.h"

namespace gurney::groundmotions {

namespace {

constexpr double kStepTolerance = 0.01;
constexpr std::size_t kLongestLine = 2000;  ///< what stands behind that is no statement

void take_unit(std::string_view line, std::size_t index, PlainFacts& facts, FileErrors& errors) {
  const auto text = unit_text_in(line);
  if (!text) return;
  const auto unit = acceleration_unit(*text);
  const auto end = static_cast<std::size_t>(text->data() - line.data()) + text->size();
  if (const auto factor = factor_behind(line.substr(end)); unit && !factor.empty())
    errors.add(index, end + 1,
               fmt::format("a factor behind the unit ('{} {}'): does it belong to the numbers or "
                           "to the unit? Scale the numbers and leave the factor out",
                           *text, factor));
  if (const auto quantity = other_quantity(*text); !unit && quantity)
    errors.add(index, 1,
               fmt::format("a record must be acceleration, but the unit '{}' is that of a {}",
                           *text, *quantity));
  else if (!unit)
    errors.add(index, 1,
               fmt::format("'{}' is not a unit of acceleration: {} are allowed", *text,
                           kAccelerationUnits));
  else if (facts.unit && facts.unit->to_si != unit->to_si)
    errors.add(index, 1,
               fmt::format("this line states the unit {}, but line {} states {}", unit->name,
                           errors.line_in_file(facts.unit_line), facts.unit->name));
  if (!unit || facts.unit) return;
  facts.unit = unit;
  facts.unit_line = index;
}

void take_step(std::string_view line, std::size_t index, PlainFacts& facts, FileErrors& errors) {
  const auto step = time_step_in(line);
  if (!step) return;
  if (facts.time_step) {
    check_step(facts, *step, fmt::format("line {}", errors.line_in_file(index)), errors);
  } else {
    facts.time_step = step;
    facts.step_line = index;
  }
}

void take_count(std::string_view line, std::size_t index, PlainFacts& facts) {
  const auto count = count_in(line);
  if (!count || facts.count) return;
  facts.count = count;
  facts.count_line = index;
}

void refuse_other_quantities(const PlainRows& rows, const std::vector<std::size_t>& lines,
                             FileErrors& errors) {
  std::vector<std::string_view> texts;
  for (const std::size_t i : lines) texts.push_back(rows.header[i].substr(0, kLongestLine));
  if (const auto other = other_quantity_in(texts))
    errors.add(rows.header_lines[lines[other->line]], 1,
               fmt::format("a record must be acceleration, but the text speaks of {} ('{}')",
                           other->quantity, texts[other->line].substr(0, 80)));
}

}  // namespace

PlainFacts plain_facts(const PlainRows& rows, const std::vector<std::size_t>& titles,
                       FileErrors& errors) {
  PlainFacts facts;
  std::vector<std::size_t> lines;
  for (std::size_t i = 0; i < rows.header.size(); ++i)
    if (std::ranges::find(titles, i) == titles.end()) lines.push_back(i);
  refuse_other_quantities(rows, lines, errors);
  for (const std::size_t i : lines) {
    const auto line = rows.header[i].substr(0, kLongestLine);
    take_unit(line, rows.header_lines[i], facts, errors);
    take_step(line, rows.header_lines[i], facts, errors);
    take_count(line, rows.header_lines[i], facts);
    if (const auto unit = time_unit_in(line)) facts.time_unit = *unit;
    if (facts.component.empty()) facts.component = component_in(line);
    if (factor_in(line) && facts.factor_line == 0) facts.factor_line = rows.header_lines[i];
  }
  return facts;
}

void check_step(const PlainFacts& facts, double step, std::string_view what, FileErrors& errors) {
  if (!facts.time_step || std::abs(*facts.time_step - step) <= kStepTolerance * step) return;
  errors.add(facts.step_line, 1,
             fmt::format("the text states a time step of {:.9g} s, but {} {:.9g} s",
                         *facts.time_step, what, step));
}

}  // namespace gurney::groundmotions
