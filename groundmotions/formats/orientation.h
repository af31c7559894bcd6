#pragma once

#include <string_view>

#include "groundmotions/record/record.h"

namespace gurney::groundmotions {

/// Sets azimuth or direction of a component from what its file calls it, whatever the letter case:
///
/// - degrees in [0, 360] clockwise from north, such as 090, 45 or 45 DEG; a lone digit from 1 to 9
///   is the number of a channel and says nothing;
/// - N, NS, N-S, NORTH...; E, EW, E-W, WE, EAST... (positive to the north and to the east);
///   S, SOUTH and W, WEST; bearings such as N38E and S38W;
/// - U, UP, UD, U-D, UPDO, V, Z, VER, VERT, VERTICAL: up;
/// - the same words of other languages: NORTE, ESTE, NORD, OST, KUZEY, DUSEY, E-O ...;
/// - DN, DWN, DOWN: the samples change sign so that they point up, with a warning;
/// - a SEED channel code of three letters ending in N, E or Z, with or without a location of two
///   digits: HNE, HGZ, BHZ00; ENE may be a point of the compass and says nothing.
///
/// Any other name (L, T, H1, HN2) sets nothing. To be called when the samples are there.
void orient(std::string_view name, Component& component);

/// Names a component as its file does and orients it by this name.
void name_and_orient(std::string_view name, Component& component);

/// Azimuth or vertical of a component as a label in a header says it: "90 DEG", "N08W", "UP",
/// "Roof, N wall: 275 deg", "VERT", "DOWN" (turned to up, with a warning), the words of orient()
/// where they are all of the label (NS, E-W), SEED codes that it begins with ("BNZ 00"). Labels
/// such as "L" or "Roof" say neither.
/// @returns whether the label says it.
bool orient_by_label(std::string_view label, Component& component);

/// Whether orient() sets anything by a name.
bool says_direction(std::string_view name);

/// Turns a component that points down, with a warning. @param why  the file's word: "DOWN"
void turn_up(std::string_view why, Component& component);

}  // namespace gurney::groundmotions
