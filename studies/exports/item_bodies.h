#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/scene/equipment_model.h"
#include "engine/scene/joint.h"

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

/// A part on its joint, or where `joint` is none a loose content; item axes.
struct PartBody {
  std::string name;
  std::optional<Joint> joint;  ///< base: 0 the chassis, i + 1 part i
  MassProperties body;
  std::vector<BodyShape> shape;
  double friction = 0, rolling_resistance = 0;  ///< of a content [-], [m]
  double yaw = 0;                               ///< of a content, about its origin [rad]
  Vector3 origin = Vector3::Zero();
  std::vector<CasterBodies> casters = {};  ///< of a part; as given, names and hinges aside
};

struct ItemBodies {
  std::string name;
  MassProperties chassis;  ///< with its payloads, item axes
  std::vector<BodyShape> shape;
  std::vector<CasterBodies> casters;
  std::vector<MarkedPoint> points;
  std::vector<PartBody> parts;  ///< contents last
};

/// Names become identifiers that differ. A brake and a swivel lock are dry friction of their
/// hinges; an infinite one holds the hinge.
/// @param parts  names aside, which then differ too
ItemBodies item_bodies(const EquipmentModel& item, std::vector<PartBody> parts = {});

/// Inertia of the wheel about its centre, fork axes [kg m2].
Matrix3 wheel_inertia(const Caster& caster);

/// `1.5 0 -2`, digits that read back as the same numbers.
std::string numbers_text(const Vector3& vector);

/// A model for MuJoCo (MJCF): the item on a plane, its shapes, sites at its marked points, its parts on their
/// joints and its contents. Latches are left out, and stops have MuJoCo's own law.
std::string mjcf_text(const ItemBodies& item);

/// Model for ROS and others (URDF): links and joints, without floor and points.
/// @throws Error for an item with parts, contents or hulls
std::string urdf_text(const ItemBodies& item);

}  // namespace gurney::study
