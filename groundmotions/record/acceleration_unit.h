#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gurney::groundmotions {

/// A unit of acceleration.
struct AccelerationUnit {
  const char* name;  ///< "g", "m/s2", "cm/s2"...
  double to_si;      ///< m/s2 in one unit
};

/// One spelling for all those of a unit: "CM/SEC**2", "cm / s²" (UTF-8 or Latin-1), "cm s^-2",
/// "cm/sec/sec", "CMS/SEC2." and "cm_per_s2" are "cm/s2"; "Gals" is "gal", "[msec]" is "ms".
/// Every reader compares units in this spelling.
std::string plain_unit(std::string_view spelling);

/// The unit meant by a spelling of files and users: g, mg, %g, g/10 (as digitisers wrote); m/s2,
/// cm/s2, mm/s2, in/s2, ft/s2; gal. Nothing for any other.
std::optional<AccelerationUnit> acceleration_unit(std::string_view spelling);

/// The names that users may give, in jobs, lists and options alike.
const std::vector<std::string>& acceleration_unit_names();

/// The same for a message: "g, m/s2, ... or in/s2".
extern const std::string kAccelerationUnits;

}  // namespace gurney::groundmotions
