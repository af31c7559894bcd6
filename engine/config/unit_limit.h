#pragma once

#include <span>
#include <string>

#include "engine/config/range.h"

namespace gurney::config {

/// Generous limit of the numbers of one unit: beyond it a file is in error, and the arithmetic of a
/// simulation would overflow.
struct UnitLimit {
  const char* ending;  ///< of a key: "_kg"; a whole key where it has no unit: "friction"
  double smallest;     ///< of a number that must be above zero
  double largest;      ///< of the magnitude
};

std::span<const UnitLimit> unit_limits();

/// The limit of a number by its name, such as `item.mass_kg.distribution.median`: that of its last
/// part with a unit. Numbers without one have a limit too.
const UnitLimit& unit_limit(const std::string& name);

/// Requirement on `name` where `value`, which `range` contains, is beyond the limit of its unit; else
/// empty.
std::string beyond_unit(const std::string& name, const Range& range, double value);

}  // namespace gurney::config
