#pragma once

#include <vector>

#include "engine/scene/scene.h"

/// An item on engines that share nothing with ours: docs/theory/peers.md.
namespace gurney::peers {

/// The item at one time.
struct Snapshot {
  Vector3 place = Vector3::Zero();  ///< its origin in plan and its yaw [m], [m], [rad]
  double tilt = 0;                  ///< of its z axis from the vertical [rad]
};

/// At equal times, the start included, until the item overturns (tilt of 60 degrees).
using Path = std::vector<Snapshot>;
inline constexpr double kOverturned = 1.0471975511965976;
Snapshot snapshot(const Vector3& origin, const Matrix3& rotation);

/// A rigid wall that the chassis alone touches: points with normal . p >= offset are free.
struct Wall {
  Vector3 normal;
  double offset;
};

/// The input of both engines: rolling resistance is Coulomb friction of the axle with the limit
/// Cr N, N that of the step before; a wheel is a sphere of its radius, which touches where a thin
/// upright disc does.
struct CrossCheck {
  Scene scene;        ///< one item on casters; treads act as rigid, no scrub, mu_s = mu_k
  FloorMotion floor;  ///< acts as gravity that changes, with its exact mean over each step
  double duration = 0;
  double sampling = 0;           ///< [s]; a whole number of steps
  std::vector<Wall> walls = {};  ///< the same as boxes in scene.room, of its default constants
};

/// Casters ahead and the floor along x and z alone: the item slides along x, and a pyramid of friction is a
/// cone.
CrossCheck along_x(CrossCheck check);

/// Defaults of the engine with the solver that its manual names first; stiff contacts with all else by
/// default (ODE: with Dantzig's solver); the most accurate set-up that was found
/// (docs/performance.md).
enum class Setup { kDefaults, kStiff, kBest };

/// Most that holds an axle or a swivel axis in both engines [N m]: Cr N, or a lock.
inline constexpr double kLocked = 1e5;
inline double axle_friction(const Caster& caster, double load) {
  return caster.brake_torque > 0 ? kLocked : caster.tread.rolling_friction_length * load;
}
inline double swivel_friction(const Caster& caster) { return caster.swivels ? 0 : kLocked; }

/// MuJoCo: generalised coordinates, soft convex contacts as stiff as the step allows, elliptic
/// friction cones, Newton's method. Defaults: contacts of 20 ms, friction pyramids.
Path mujoco_path(const CrossCheck& check, double time_step, Setup setup);

/// ODE: bodies and hinges, Dantzig's solver. Friction of kStiff: pyramids along and across each caster,
/// limited by the loads that the wheels would have without friction (ODE's manual, section 7.3.7,
/// dContactApprox1); of kBest: against the slip, limited by the loads of the step before. Defaults:
/// QuickStep, rigid contacts.
Path ode_path(const CrossCheck& check, double time_step, Setup setup);

}  // namespace gurney::peers
