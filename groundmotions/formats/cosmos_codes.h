#pragma once

#include <optional>

#include "groundmotions/record/acceleration_unit.h"

namespace gurney::groundmotions {

/// Codes of the COSMOS Strong Motion Data Format, version 1.20 (2001), tables 1, 2 and 8.

/// Table 1: what integer 2 of the header says was measured: "acceleration", "velocity", ...;
/// nullptr for an unknown code.
const char* cosmos_quantity(int code);

/// Table 2: units of acceleration of integer 3 of the header; nothing for all others.
std::optional<AccelerationUnit> cosmos_unit(int code);
inline constexpr int kCosmosCounts = 50;

/// Table 6: the structure that integer 19 of the header says a station is in: "a bridge"; nullptr
/// for the free field and unknown codes.
const char* cosmos_structure(int code);

/// Table 8: what a code above 360 says of a sensor's orientation: "up", "radial", ...; nullptr for
/// an unknown code.
const char* cosmos_orientation(int code);
inline constexpr int kCosmosUp = 400, kCosmosDown = 401, kCosmosVertical = 402;

}  // namespace gurney::groundmotions
