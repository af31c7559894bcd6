#include "groundmotions/formats/plain_facts.h"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "groundmotions/formats/header_text.h"
#include "groundmotions/formats/unit_text.h"

namespace gurney::groundmotions {

namespace {

constexpr double kStepTolerance = 0.01;

void take_unit(std::string_view line, std::size_t index, PlainFacts& facts, FileErrors& errors) {
  const auto text = unit_text_in(line);
  if (!text) return;
  const auto unit = acceleration_unit(*text);
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

void refuse_other_quantities(const PlainRows& rows, std::size_t count, FileErrors& errors) {
  const std::vector<std::string_view> lines(rows.header.begin(),
                                            rows.header.begin() + static_cast<long>(count));
  if (const auto other = other_quantity_in(lines))
    errors.add(rows.header_lines[other->line], 1,
               fmt::format("a record must be acceleration, but the text speaks of {} ('{}')",
                           other->quantity, lines[other->line].substr(0, 80)));
}

}  // namespace

PlainFacts plain_facts(const PlainRows& rows, bool with_titles, FileErrors& errors) {
  PlainFacts facts;
  const std::size_t count = rows.header.size() - (with_titles && !rows.header.empty() ? 1 : 0);
  refuse_other_quantities(rows, count, errors);
  for (std::size_t i = 0; i < count; ++i) {
    take_unit(rows.header[i], rows.header_lines[i], facts, errors);
    take_step(rows.header[i], rows.header_lines[i], facts, errors);
    if (const auto unit = time_unit_in(rows.header[i])) facts.time_unit = *unit;
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
