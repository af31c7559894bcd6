#pragma once

#include <string>
#include <vector>

#include "engine/scene/equipment_model.h"

/// An item as the rigid bodies and hinges of programs for multibody systems.
namespace gurney::study {

/// Friction of a hinge: |torque| <= `dry` at rest [N m], and `viscous` times its rate [N m s/rad].
struct Hinge {
  bool turns = true;
  double dry = 0, viscous = 0;
};

/// A fork below the chassis and a wheel in it, with their names.
struct CasterBodies {
  std::string fork, wheel;
  Caster caster;
  Hinge swivel, axle;
};

struct ItemBodies {
  std::string name;
  MassProperties chassis;  ///< with its payloads, item axes
  std::vector<Box> shape;
  std::vector<CasterBodies> casters;
  std::vector<MarkedPoint> points;
};

/// Names become identifiers that differ. A brake and a swivel lock are dry friction of their
/// hinges; an infinite one holds the hinge.
ItemBodies item_bodies(const EquipmentModel& item);

/// Inertia of the wheel about its centre, fork axes [kg m2].
Matrix3 wheel_inertia(const Caster& caster);

/// `1.5 0 -2`, digits that read back as the same numbers.
std::string numbers_text(const Vector3& vector);

/// A model for MuJoCo (MJCF): the item on a plane, its boxes, sites at its marked points.
std::string mjcf_text(const ItemBodies& item);

/// Model for ROS and others (URDF): links and joints, without floor and points.
std::string urdf_text(const ItemBodies& item);

}  // namespace gurney::study
