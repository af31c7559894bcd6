#pragma once

#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace gurney::groundmotions {

/// Name and value of something that the source of a record states.
using NamedFacts = std::vector<std::pair<std::string, std::string>>;

/// Earthquake and site of a record as its source states them; NaN: it does not.
struct SourceFacts {
  double magnitude = std::numeric_limits<double>::quiet_NaN();  ///< moment magnitude if stated
  double distance = std::numeric_limits<double>::quiet_NaN();   ///< [m]
  std::string distance_kind;  ///< "Rrup", "Rjb", "epicentral" or "not stated"; empty: no distance
  double vs30 = std::numeric_limits<double>::quiet_NaN();              ///< [m/s]
  double lowest_frequency = std::numeric_limits<double>::quiet_NaN();  ///< usable [Hz]
  std::string event;    ///< identification, name or time of the earthquake; empty: not stated
  std::string station;  ///< name or code; empty: not stated
};

/// Distances to the rupture are preferred to those to its projection (Rjb), and these to those to
/// the epicentre. Values out of bounds, such as -999, are none. The line of a PEER file that names
/// both, "Northridge-01, 1/17/1994, Rinaldi Receiving Sta, 228", is event with date and station.
/// @param sources  the first that states a fact decides
SourceFacts source_facts(const std::vector<NamedFacts>& sources);

}  // namespace gurney::groundmotions
