#pragma once

#include <optional>
#include <string_view>

#include "groundmotions/record/acceleration_unit.h"

namespace gurney::groundmotions {

/// The unit of acceleration that a header line names somewhere, letter case apart: "UNITS: G)",
/// "SEC AND G/10.", "in cm/sec2.". A tenth of g is "g/10".
std::optional<AccelerationUnit> unit_in(std::string_view line);

/// Seconds in a unit of time: s, sec, seconds, ms, msec, milliseconds, us, min, minutes; nothing
/// for any other.
std::optional<double> time_unit(std::string_view spelling);

/// A factor right behind a unit: "x 10" of ") x 10", "/1000", "* 1e3"; empty if there is none.
std::string_view factor_behind(std::string_view unit_end);

/// "velocity" or "displacement" if that is what the unit measures, else nothing.
std::optional<std::string_view> other_quantity(std::string_view unit);

}  // namespace gurney::groundmotions
