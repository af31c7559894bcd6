#pragma once

#include <optional>
#include <string_view>

namespace gurney {

/// A unit of acceleration.
struct AccelerationUnit {
  const char* name;  ///< "g", "m/s2", "cm/s2" or "mm/s2"
  double to_si;      ///< m/s2 in one unit
};

/// The unit meant by a spelling of files and users, letter case apart: g; m/s2, m/s/s, m/s^2,
/// m/s**2, m/sec2, m/sec/sec and the same with cm and mm; gal. Nothing for any other.
std::optional<AccelerationUnit> acceleration_unit(std::string_view spelling);

/// What to write in a message about a wrong unit.
inline constexpr const char* kAccelerationUnits = "g, m/s2, cm/s2 (gal) or mm/s2";

}  // namespace gurney
