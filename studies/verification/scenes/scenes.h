#pragma once

#include <functional>
#include <vector>

#include "engine/response/response.h"
#include "engine/scene/scene.h"
#include "engine/scene/settings.h"

/// Items, floors and fixtures that verification tests and benchmarks share.
namespace gurney::scenes {

/// A swivel caster with a rubber wheel of 100 mm: a uniform disc of 0.25 kg, trail 34 mm.
Caster rubber_caster();

/// Gives the wheel the inertia of a uniform disc of its mass and radius times `ratio`.
void set_wheel_inertia(Caster& caster, double ratio = 1);

/// Makes tread deflections invisible: k_n 3e8, k_t 1e9 N/m. A rigid wheel on a rigid floor is the
/// limit that most closed forms hold for. The normal damping stays 9 % of critical: nearly
/// undamped, friction couples heave and pitch of a sliding block into a growing vibration (with and
/// without refinement of the step), which no closed form of a block knows.
void stiffen(Tread& tread);

/// Parts of an item; every caster is a copy of `caster`.
struct ItemOptions {
  double total_mass = 96.5;  ///< with the casters [kg]
  Vector3 chassis_center = Vector3(0, 0, 0.618);
  Caster caster = rubber_caster();
  std::vector<double> headings;  ///< one for each caster; missing ones are 0 [rad]
  double half_wheelbase = 0.49;  ///< of the swivel axes; four-caster items only [m]
  double half_track = 0.215;     ///< [m]
};

/// The pulling-test trolley: casters front left, front right, rear left, rear right.
/// Its marked point is the centre of mass of the whole item at its initial headings.
EquipmentModel trolley(const ItemOptions& options = {});

/// The trolley with rigid forks and wheels that cannot turn: a sliding block.
EquipmentModel locked_block(ItemOptions options = {});

/// One caster below a small chassis, the swivel axis through its centre of mass: for fixtures.
EquipmentModel single_caster(double total_mass, const Caster& caster);

/// Holds the rotations about the axes given.
Fixture hold_rotations(bool roll = true, bool pitch = true, bool yaw = true);

/// Tows along x at `speed`; the height is free, all else is held.
Fixture tow(double speed);

/// Floor acceleration f(t) along `direction`, sampled every `time_step`.
FloorMotion floor_motion(double time_step, double duration, const Vector3& direction,
                         const std::function<double(double)>& acceleration);

/// A constant floor acceleration from 0 to `duration`.
FloorMotion rectangular_pulse(double acceleration, double duration,
                              const Vector3& direction = Vector3::UnitX());

/// A constant force from 0 to `duration`.
PointForce constant_force(double force, double duration, const Vector3& point,
                          const Vector3& direction = Vector3::UnitX());

/// Total mass with the casters [kg].
double total_mass(const EquipmentModel& item);

/// Sum of I_w / R^2: what the spin of rolling wheels adds to the mass [kg].
double wheel_inertia_mass(const EquipmentModel& item);

/// Settings of a run of a fixed length.
SimulationSettings run_for(double duration, double time_step, double history_step = 0);

}  // namespace gurney::scenes
