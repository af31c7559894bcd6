#pragma once

#include <vector>

#include "engine/scene/scene.h"

/// An item on engines that share nothing with ours: docs/theory/peers.md.
namespace gurney::peers {

/// The item's origin in plan and its yaw at equal times, the start included [m], [m], [rad].
using Path = std::vector<Vector3>;

/// The input of both engines: rolling resistance is Coulomb friction of the axle with the limit
/// Cr N, N that of the step before; a wheel is a sphere of its radius, which touches where a thin
/// upright disc does.
struct CrossCheck {
  Scene scene;        ///< one item on casters; treads act as rigid, no scrub, mu_s = mu_k
  FloorMotion floor;  ///< acts as gravity that changes, with its exact mean over each step
  double duration = 0;
  double sampling = 0;  ///< [s]; a whole number of steps
};

/// Most that holds an axle or a swivel axis in both engines [N m]: Cr N, or a lock.
inline constexpr double kLocked = 1e5;
inline double axle_friction(const Caster& caster, double load) {
  return caster.brake_torque > 0 ? kLocked : caster.tread.rolling_friction_length * load;
}
inline double swivel_friction(const Caster& caster) { return caster.swivels ? 0 : kLocked; }

/// MuJoCo: generalised coordinates, soft convex contacts as stiff as the step allows, elliptic
/// friction cones, Newton's method.
Path mujoco_path(const CrossCheck& check, double time_step);

/// ODE: bodies and hinges, Dantzig's solver, friction pyramids along and across each caster.
Path ode_path(const CrossCheck& check, double time_step);

}  // namespace gurney::peers
