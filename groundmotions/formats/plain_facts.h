#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "groundmotions/formats/plain_rows.h"
#include "groundmotions/formats/stated.h"

namespace gurney::groundmotions {

/// Statements of the free text above plain numbers. Lines are counted from 1.
struct PlainFacts {
  std::optional<AccelerationUnit> unit;
  std::size_t unit_line = 0;
  std::optional<double> time_step;  ///< [s]
  std::size_t step_line = 0;
  std::optional<double> count;  ///< of the samples of a component
  std::size_t count_line = 0;
  std::string component;        ///< its direction, where the text states one
  std::size_t factor_line = 0;  ///< of a factor for the numbers; 0: none
  double time_unit = 1;         ///< of a column of times without a title of its own [s]
};

/// Errors: samples that are velocity or displacement as the text says, a unit that is none of
/// acceleration or has a factor behind it, and lines that contradict each other.
/// @param titles  lines of the header (from 0) that name the columns and are not looked at
PlainFacts plain_facts(const PlainRows& rows, const std::vector<std::size_t>& titles,
                       FileErrors& errors);

/// An error if `step` [s], which `what` gives, is farther from that of the text than its rounding
/// explains: 1 %, an assumption.
void check_step(const PlainFacts& facts, double step, std::string_view what, FileErrors& errors);

}  // namespace gurney::groundmotions
