#pragma once

#include <vector>

#include "engine/caster/caster_dynamics.h"
#include "engine/contact/body_form.h"
#include "engine/scene/scene.h"
#include "engine/solver/loads.h"
#include "engine/solver/state.h"
#include "engine/solver/tethers.h"

namespace gurney {

/// A point of a wheel, relative to the chassis' centre, floor axes.
Vector3 point_of(const CasterDynamics& caster, const Pose& pose, double swivel_angle,
                 const BodyContact::Side& side);

/// Gravity in floor axes, whose z axis is normal to a floor that rises by `slope` along x and
/// `cross_slope` along y.
Vector3 gravity_on_slope(double gravity, double slope, double cross_slope);

/// The constants of one item on its casters under its loads: what a run reads and never changes.
struct Mechanism {
  Mechanism(const Scene& scene, std::size_t item);

  MassProperties chassis;  ///< with payloads; item axes
  std::vector<CasterDynamics> casters;
  std::vector<RoundSurface> surfaces;  ///< as EquipmentModel::shape
  Loads loads;
  Tethers tethers;
  Fixture fixture;
  Vector3 gravity;    ///< floor axes: the floor may slope
  double total_mass;  ///< [kg]
  double length;      ///< characteristic, for residuals of moments [m]
  double reach;       ///< largest distance of any point of the item from the chassis' centre [m]

  /// A point of the item (BodyContact::Side), relative to the chassis' centre, floor axes; and its
  /// velocity, without the spin of a wheel, which moves no point of its surface.
  Vector3 point(const BodyContact::Side& side, const State& state) const;
  /// A point of the chassis as it is turned, relative to its centre, floor axes.
  Vector3 chassis_point(const BodyContact::Side& side, const Matrix3& rotation) const {
    return side.round < 0 ? Vector3(rotation * side.local)
                          : surfaces[static_cast<std::size_t>(side.round)].farthest(
                                rotation, side.local, side.outwards);
  }
  Vector3 velocity(const BodyContact::Side& side, const State& state) const;
  /// 1 / the mass that an impulse along `normal` feels there of the chassis alone: more than that
  /// of all the item [1/kg].
  double mobility(const BodyContact::Side& side, const Vector3& normal, const State& state) const;
  /// Mobility by a force along a generalised direction of the chassis.
  double mobility(const Vector6& direction, const State& state) const;

  /// The item as it is placed: chassis pose, headings, initial velocity with rolling wheels; treads
  /// unloaded.
  State placed(const InitialMotion& initial) const;
  /// Sets velocities of a state: wheels roll without slip, or stand still.
  void set_in_motion(const InitialMotion& initial, State& state) const;
};

}  // namespace gurney
