#pragma once

#include <cstdint>
#include <vector>

#include "engine/base/floor_motion.h"
#include "engine/response/response.h"
#include "engine/scene/scene.h"
#include "engine/scene/settings.h"

/// Small scenes for tests: plain items whose closed forms are short.
namespace gurney::small {

/// A point contact without losses: patch width 0, rolling resistance 0, no damping.
Tread bare_tread(double normal_stiffness, double tangential_stiffness);

/// A caster with a fork of 0.25 kg whose centre of mass is halfway to the wheel, and a wheel of
/// 0.25 kg and radius 50 mm; `heading` in degrees.
Caster caster(const Vector3& mount, double heading_degrees, const Tread& tread,
              double trail = 0.034);

/// Inertia of fork and wheel about the swivel axis [kg m2].
double swivel_inertia(const Caster& caster);

/// A chassis of 94.5 kg, centre of mass 0.5 m high, with a caster at every mount (x, y in m):
/// 96.5 kg on four casters.
EquipmentModel item_on(const std::vector<Vector2>& mounts, const std::vector<double>& headings,
                       const Tread& tread);

/// item_on() with four casters at (+-0.4, +-0.2).
EquipmentModel trolley(const std::vector<double>& headings, const Tread& tread);

/// One caster under a chassis that is led along x at `speed` and free to move vertically only.
Scene towed_caster(double speed, double trail, double heading, const Tread& tread);

/// Settings for a run of exactly `duration` that keeps every `stride`-th step.
SimulationSettings settings_for(double time_step, double duration, int stride = 1);

/// White noise through a lightly damped oscillator of 1.5 Hz (horizontal) or 8 Hz (vertical), with
/// a rise and a fall of a quarter of the duration each; peak of each component as given [m/s2].
/// The same bits everywhere: integer random numbers, plain arithmetic.
FloorMotion noise_record(std::uint64_t seed, double duration, const Vector3& peaks);

/// Eigenvalues lambda of a linear recurrence of `order` that the samples x_n, spaced by `step`,
/// follow: x = sum c_k exp(lambda_k t) (Prony 1795), by least squares.
Eigen::VectorXcd exponents(const std::vector<double>& samples, double step, int order);

/// One step of the two-stage method of engine/solver/quadrature.h for y' = A y: its stability
/// function R(h A) = (I + (1 - 2 gamma) h A) (I - gamma h A)^-2.
Eigen::MatrixXd sdirk_step(const Eigen::MatrixXd& a, double step);

}  // namespace gurney::small
