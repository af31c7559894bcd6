#pragma once

#include <string>
#include <vector>

#include "engine/scene/equipment_model.h"

namespace gurney::equipment {

/// Static stability of an item on a level floor.
///
/// A caster that swivels puts its wheel anywhere on a circle of radius trail round its mount, so
/// the base shrinks when the wheels turn inwards. With m_i the mounts, t_i the trails (0 and the
/// wheel's own place for a rigid or locked fork) and c the centre of mass in plan, the item held
/// at its worst leans over the edge with normal n when tilted by atan(b / h),
///
///     b(n) = max_i (m_i . n - t_i) - c . n,    h = height of c;
///
/// the smallest over n is exact, since each fork turns by itself. Limits: wheels and forks count
/// for the centre of mass at their initial headings; the tread does not yield; the brake holds.
struct Stability {
  double base = 0;                  ///< smallest b over all directions and swivel angles [m]
  double height = 0;                ///< h [m]
  double tilt = 0;                  ///< atan(base / height); < 0: it can fall by itself [rad]
  double direction = 0;             ///< of that fall, from the item's x axis, anticlockwise [rad]
  double tilt_as_placed = 0;        ///< the same with the wheels at their initial headings [rad]
  std::vector<double> wheel_loads;  ///< normal forces at the initial headings, 1 g [N]
  std::vector<std::string> warnings;
};

/// Wheel loads are those of a rigid chassis on the casters' tread stiffnesses, lifted wheels left
/// out; none without casters, where the support are the corners of the lowest boxes. Warns below 10
/// degrees, the tilt IEC 60601-1 asks of mobile equipment in its transport position (5 degrees
/// without casters: in any other position), and where the centre of mass can leave the support
/// polygon. A base that reaches beyond the chassis is no fault.
/// @pre `validate(item)` holds.
Stability stability_of(const EquipmentModel& item);

}  // namespace gurney::equipment
