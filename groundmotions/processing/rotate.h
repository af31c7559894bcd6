#pragma once

#include "groundmotions/record/record.h"

namespace gurney::groundmotions {

/// Turning the horizontals of a record. h2 is h1 turned 90 degrees counter-clockwise seen from
/// above; azimuths count clockwise from north, so azimuth(h2) = azimuth(h1) - 90 degrees.

/// The horizontals as a pair at right angles in that sense, h1 as it is. By the azimuths of the
/// two:
/// - h2 is 90 degrees counter-clockwise of h1: the record as it is;
/// - h2 is 90 degrees clockwise of h1 (a mirror image): h2 is negated, its azimuth turned by 180;
/// - any other angle: h2 is solved from the two. With e(z) = (sin z, cos z) in east and north, the
///   motion u has e(z1) . u = a1, e(z2) . u = a2; the new h2 is e(z1 - 90 degrees) . u.
/// The rotation is stated by a line of record.processing. A record without both horizontals or without both
/// azimuths is given back as it is.
/// @throws Error if the directions are less than 30 degrees from parallel (an assumption: noise
///         would be more than doubled).
Record orthogonal_horizontals(Record record);

/// The horizontals seen along other axes: h1 turned by `angle` counter-clockwise seen from above
/// [rad],
///
///     a_h1' =  cos(angle) a_h1 + sin(angle) a_h2
///     a_h2' = -sin(angle) a_h1 + cos(angle) a_h2
///
/// Azimuths, where known, become less by `angle`; names become azimuths: "030".
/// @throws Error without both horizontals, and unless angle is finite.
Record rotated_by(Record record, double angle);

/// orthogonal_horizontals() turned so that h1 has this azimuth [rad].
/// @throws Error also without both azimuths.
Record rotate_to(Record record, double azimuth_of_h1);

/// rotate_to() with h1 normal and h2 parallel to a fault: h1 at strike + 90 degrees, h2 at the
/// strike.
/// @param strike  of the fault, clockwise from north [rad]
Record rotate_to_fault(Record record, double strike);

}  // namespace gurney::groundmotions
