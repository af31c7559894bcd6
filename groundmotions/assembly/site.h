#pragma once

#include <string>
#include <string_view>

#include "groundmotions/record/record.h"

namespace gurney::groundmotions {

/// The value of a fact of a component's header; empty if it is not there.
std::string fact_of(const Component& component, std::string_view name);

/// A text in one spelling: capitals, one blank for each run of other characters than letters and
/// digits. "Roof,  N wall" is "ROOF N WALL".
std::string plain_words(std::string_view text);

/// Place and instrument of a component as its file states them: location in a structure, borehole
/// or surface sensor, band and instrument of a SEED channel code, and without a location the serial
/// number of the recorder. Empty if the file states none. Components of one record have one site.
std::string site_of(const Component& component);

/// The structure or the place in one that the file names for a sensor: "a building, floor 12",
/// "Roof, N wall". Empty for the free field and where nothing is said.
std::string structure_of(const Component& component);

}  // namespace gurney::groundmotions
