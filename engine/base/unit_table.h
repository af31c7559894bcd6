#pragma once

#include <string>
#include <string_view>
#include <vector>

/// The one table of units: what a file may state a limit, a level or a hazard in, and what reports
/// may print. tests/system/python/unit_tables.py compares that of the Python package with it.
namespace gurney {

/// Properties of a quantity, by its SI unit.
struct SiUnit {
  const char* name;
  const char* pelicun;     ///< what pelicun calls it; empty: it has no such unit
  double smallest_change;  ///< of a demand, that somebody could measure; NaN: a time step
};

/// Units in which a file may state a limit or a level of a quantity.
/// @param si  its SI unit, such as "m/s2"
std::vector<std::string> units_in_files(std::string_view si);

/// One unit in SI.
/// @throws Error for a name that the table lacks
double in_si(std::string_view unit);

/// @returns null for a unit of no demand
const SiUnit* si_unit(std::string_view name);

}  // namespace gurney
