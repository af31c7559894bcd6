#pragma once

#include <string>
#include <vector>

#include "engine/scene/equipment_model.h"

namespace gurney::equipment {

/// Where a wheel stands in plan: somewhere on a circle round `center`; or a corner of a foot.
struct Support {
  Vector2 center;  ///< item axes [m]
  double radius;   ///< >= 0 [m]
};

enum class Swivels {
  kAsPlaced,  ///< forks at their initial headings: all radii are 0
  kAnywhere   ///< free forks stand as is worst; locked and rigid ones as placed
};

/// Supports of an item; without casters the points of its shapes (outline_points) on the floor, within
/// 1e-6 m of the lowest of all.
std::vector<Support> supports_of(const EquipmentModel& item, Swivels swivels);

/// How far a point lies inside an edge of the supports.
struct Margin {
  double distance;   ///< negative: outside [m]
  double direction;  ///< of the edge's outward normal, from the x axis, anticlockwise [rad]
};

/// The edge nearest to `point`: the smallest over all directions n of
/// max_i(center_i . n - radius_i) - point . n. Exact: between directions in which two supports
/// tie, every branch is a sinusoid.
Margin smallest_margin(const std::vector<Support>& supports, const Vector2& point);

/// How far `point` can go towards `direction` before it leaves the supports: the smallest over the
/// edges m of margin(m) / (m . direction). Exact for the same reason. Infinite without such an
/// edge.
/// @param direction  from the x axis, anticlockwise [rad]
double reach_towards(const std::vector<Support>& supports, const Vector2& point, double direction);

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
/// out; none without casters, where the support are the lowest points of its shapes. Warns below 10
/// degrees, the tilt IEC 60601-1 asks of mobile equipment in its transport position (5 degrees
/// without casters: in any other position), and where the centre of mass can leave the support
/// polygon. A base that reaches beyond the chassis is no fault.
/// @pre `validate(item)` holds.
Stability stability_of(const EquipmentModel& item);

}  // namespace gurney::equipment
