#pragma once

#include <string>
#include <vector>

#include "engine/base/vector.h"
#include "engine/scene/body_shape.h"

/// Plain description of one item of equipment, in item axes (engine/base/vector.h), SI units.
namespace gurney {

/// A mass fixed to the chassis.
struct Payload {
  std::string name;
  double mass = 0;                           ///< > 0 [kg]
  Vector3 center_of_mass = Vector3::Zero();  ///< [m]
  Matrix3 inertia = Matrix3::Zero();         ///< about its own centre of mass, >= 0 [kg m2]
};

/// A named point of the chassis whose motion is reported.
struct MarkedPoint {
  std::string name;
  Vector3 position = Vector3::Zero();  ///< [m]
};

/// Wheel on floor: the constants of the tread law (docs/theory/tread.md).
struct Tread {
  double normal_stiffness = 3e5;          ///< k_n > 0 [N/m]
  double normal_damping = 500;            ///< c_n >= 0 [N s/m]
  double tangential_stiffness = 1e5;      ///< k_t > 0 [N/m]
  double tangential_damping = 150;        ///< c_t >= 0 [N s/m]
  double relaxation_length = 0.01;        ///< sigma >= 1e-4: over this roll the patch forgets [m]
  double patch_width = 0.008;             ///< w >= 0: scrub torque is at most mu N w / 4 [m]
  double rolling_friction_length = 1e-3;  ///< Cr >= 0, a length: f_r = (Cr / R) N [m]
  double static_friction = 0.6;           ///< mu_s >= mu_k [-]
  double kinetic_friction = 0.6;          ///< mu_k >= 0 [-]
};

/// Friction of a bearing: |torque| <= coulomb at rest, coulomb + viscous |rate| in motion.
struct BearingFriction {
  double coulomb = 0;  ///< >= 0 [N m]
  double viscous = 0;  ///< >= 0 [N m s/rad]
};

/// One caster, or one wheel on a rigid fork.
///
/// Fork axes: origin at the mount, z along the swivel axis (upwards), x the direction in which the
/// caster rolls when it trails; the wheel centre is at (-trail, 0, -(height - wheel_radius)).
struct Caster {
  std::string name;
  Vector3 mount = Vector3::Zero();  ///< where the swivel axis meets the top plate; z = height [m]
  double height = 0.131;            ///< top plate to floor, unloaded, > wheel_radius [m]
  bool swivels = true;              ///< false: the fork is fixed to the chassis at `heading`
  double heading = 0;          ///< initial angle of the fork's x axis from the item's x axis [rad]
  double trail = 0.034;        ///< swivel axis to wheel centre, >= 0 [m]
  double wheel_radius = 0.05;  ///< R > 0 [m]
  double wheel_width = 0.032;  ///< for the shape, > 0 [m]
  double wheel_mass = 0.25;    ///< > 0 [kg]
  double wheel_axial_inertia = 0;                 ///< about the axle, > 0 [kg m2]
  double wheel_transverse_inertia = 0;            ///< about a diameter, > 0 [kg m2]
  double fork_mass = 0.25;                        ///< > 0 [kg]
  Vector3 fork_center_of_mass = Vector3::Zero();  ///< fork axes [m]
  Matrix3 fork_inertia = Matrix3::Zero();         ///< about its centre of mass, fork axes [kg m2]
  Tread tread;
  BearingFriction axle;
  BearingFriction swivel;
  // Both hold by springs of ten times the tread's stiffness (docs/theory/tread.md).
  double brake_torque = 0;         ///< held on the axle; 0: brake off; infinite: never slips [N m]
  double brake_sliding_ratio = 1;  ///< torque of a brake that slips over that, 0.1..1
  double swivel_lock_torque = 0;   ///< on the swivel; 0: free; infinite: never slips [N m]
};

/// One item: a rigid chassis with payloads on up to 8 casters; without casters the lowest of its
/// shapes stand on the floor.
struct EquipmentModel {
  static constexpr std::size_t kMaxCasters = 8;
  static constexpr std::size_t kMaxTethers = 32;

  std::string name;
  double chassis_mass = 0;                           ///< without payloads and casters, > 0 [kg]
  Vector3 chassis_center_of_mass = Vector3::Zero();  ///< [m]
  Matrix3 chassis_inertia = Matrix3::Zero();         ///< about its centre of mass [kg m2]
  std::vector<BodyShape> shape;                      ///< collision shape of the chassis, 1 or more
  std::string material;                              ///< of the chassis: see Scene::pairs
  std::vector<Payload> payloads;
  std::vector<Caster> casters;  ///< 0 to 8
  std::vector<MarkedPoint> marked_points;
};

/// Mass, centre of mass and inertia of a rigid assembly.
struct MassProperties {
  double mass = 0;
  Vector3 center_of_mass = Vector3::Zero();
  Matrix3 inertia = Matrix3::Zero();  ///< about center_of_mass

  /// Adds a rigid part (parallel-axis theorem).
  void add(double part_mass, const Vector3& part_center, const Matrix3& part_inertia);
};

/// Chassis with its payloads.
MassProperties chassis_with_payloads(const EquipmentModel& item);

/// Everything, casters at their initial headings.
MassProperties whole_item(const EquipmentModel& item);

/// Inertia about the centre of a uniform solid box [kg m2].
Matrix3 solid_box_inertia(double mass, const Vector3& size);

/// @throws Error naming every constant outside its range.
void validate(const EquipmentModel& item);

}  // namespace gurney
