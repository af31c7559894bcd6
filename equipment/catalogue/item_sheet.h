#pragma once

#include <string>
#include <vector>

#include "engine/scene/contact_pair.h"
#include "engine/scene/equipment_model.h"
#include "equipment/catalogue/support.h"

namespace gurney::equipment {

/// Static tilt towards one direction: the item leans over when the floor is tilted that way by
/// atan(r / h), r the distance of its centre of mass to the end of the support, h its height.
struct TiltTowards {
  double direction = 0;  ///< from the item's x axis, anticlockwise [rad]
  double as_placed = 0;  ///< wheels at their initial headings [rad]
  double worst = 0;      ///< free swivels turned the worst way [rad]
};

/// A wheel at rest on a level floor.
struct WheelAtRest {
  std::string caster;
  Vector2 contact = Vector2::Zero();  ///< in plan [m]
  double load = 0;                    ///< N [N]
  double sink = 0;                    ///< of the tread, N / k_n [m]
};

/// Properties that follow from an item's constants alone. Limits: a rigid chassis on a level floor;
/// the accelerations are those of a slowly growing horizontal push of the floor.
struct ItemSheet {
  MassProperties whole;
  Vector3 principal_inertia = Vector3::Zero();  ///< about the centre of mass, growing [kg m2]
  Vector3 size = Vector3::Zero();               ///< over shapes and mounts, from the floor up [m]
  Stability stability;
  std::vector<TiltTowards> tilts;        ///< every 15 degrees
  std::vector<WheelAtRest> wheels;       ///< one for each caster
  std::vector<Vector2> support_polygon;  ///< as placed, anticlockwise [m]

  double rolling_resistance_force =
      0;  ///< sum of (Cr / R) N and of axle friction / R, brakes off [N]
  double rolling_resistance_coefficient =
      0;                     ///< over the weight: from this floor acceleration it rolls [g]
  double sliding_share = 0;  ///< sum of mu_s N over the weight: held wheels or feet slide [g]
  /// Brakes as they are, wheels in line: sum of min(mu_s N, (brake + axle friction + Cr N) / R)
  /// over the weight; from there some wheels turn or slide [g]. Without casters: sliding_share.
  double holding_share = 0;
  double tipping_share = 0;  ///< b / h as placed: an item that is held tips [g]
};

/// @param floor  of an item without casters with the floor
ItemSheet item_sheet(const EquipmentModel& item, const ContactConstants& floor = {});

}  // namespace gurney::equipment
