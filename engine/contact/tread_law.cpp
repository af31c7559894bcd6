#include "engine/contact/tread_law.h"

#include <algorithm>
#include <cmath>

namespace gurney {
namespace {

/// The stuck rolling resistance is this much stiffer than the tread it acts through.
constexpr double kStickStiffnessRatio = 10;

Vector3 slip_rates(const Vector5& u) { return {u[0], u[1], u[3]}; }

}  // namespace

TreadLaw::TreadLaw(const Tread& tread, double wheel_radius)
    : tread_(tread), spin_radius_(tread.patch_width / 4) {
  roll_.stiffness = kStickStiffnessRatio * tread.tangential_stiffness * wheel_radius * wheel_radius;
}

TreadLaw::Normal TreadLaw::normal(double compression, double u_z, double tau) const {
  if (compression <= 0) return {0, 0, 0};
  const double elastic = tread_.normal_stiffness * compression;
  const double damping = -tread_.normal_damping * u_z;
  const double elastic_slope = tread_.normal_stiffness * tau;
  if (damping <= -elastic) return {0, 0, -elastic};
  if (damping >= elastic) return {2 * elastic, 2 * elastic_slope, elastic};
  return {elastic + damping, elastic_slope + tread_.normal_damping, damping};
}

Vector5 TreadLaw::force(const Stage& stage, const Vector5& u, Matrix5& slope) const {
  const Normal n = normal(stage.compression - stage.tau * u[2], u[2], stage.tau);
  if (n.force <= 0) {
    slope.setZero();
    return Vector5::Zero();
  }
  const double memory = 1 / (1 + stage.tau * stage.rolling_speed / tread_.relaxation_length);
  const double damping_rate = tread_.tangential_damping / stage.tau;
  const double stiffness = tread_.tangential_stiffness + damping_rate;
  const Vector3 trial_deflection = memory * (stage.start.deflection + stage.tau * slip_rates(u));
  Vector3 patch = damping_rate * stage.start.deflection - stiffness * trial_deflection;
  const double mu = stage.start.sliding ? tread_.kinetic_friction : tread_.static_friction;
  const double limit = mu * n.force;
  const double size = patch.norm();
  Matrix3 patch_slope = Matrix3::Identity() * (stiffness * memory * stage.tau);
  Vector3 patch_by_normal = Vector3::Zero();
  if (size > limit) {
    const Vector3 direction = patch / size;
    patch = limit * direction;
    patch_slope =
        (limit / size) * (patch_slope - patch_slope(0, 0) * direction * direction.transpose());
    patch_by_normal = mu * n.slope * direction;
  }

  const auto roll = roll_.evaluate(stage.start.roll_deflection, u[4],
                                   tread_.rolling_friction_length * n.force, stage.tau);
  const double roll_by_normal = roll.limit_slope * tread_.rolling_friction_length * n.slope;
  const Matrix3& s = patch_slope;
  slope << s(0, 0), s(0, 1), patch_by_normal[0], s(0, 2), 0,  //
      s(1, 0), s(1, 1), patch_by_normal[1], s(1, 2), 0,       //
      0, 0, n.slope, 0, 0,                                    //
      s(2, 0), s(2, 1), patch_by_normal[2], s(2, 2), 0,       //
      0, 0, roll_by_normal, 0, roll.rate_slope;
  return (Vector5() << patch[0], patch[1], n.force, patch[2], roll.torque).finished();
}

TreadLaw::Result TreadLaw::finish(const Stage& stage, const Vector5& u,
                                  const Vector5& force) const {
  Result result;
  result.force = force;
  result.compression = stage.compression - stage.tau * u[2];
  result.compression_rate = -u[2];
  const Normal n = normal(result.compression, u[2], stage.tau);
  result.damping_power = -n.damping_force * u[2];
  if (n.force <= 0) return result;  // off the floor the patch springs back at once

  const double damping_rate = tread_.tangential_damping / stage.tau;
  const double stiffness = tread_.tangential_stiffness + damping_rate;
  const Vector3 patch = slip_rates(result.force);
  const Vector3& start = stage.start.deflection;
  const Vector3 end = (damping_rate * start - patch) / stiffness;
  const Vector3 deflection_rate = (end - start) / stage.tau;
  const Vector3 relaxation = stage.rolling_speed / tread_.relaxation_length * end;
  const Vector3 slip = slip_rates(u) - relaxation - deflection_rate;
  result.end.deflection = end;
  const double mu = stage.start.sliding ? tread_.kinetic_friction : tread_.static_friction;
  result.end.sliding = patch.norm() >= mu * n.force * (1 - 1e-12);
  result.relaxation_power = -patch.dot(relaxation);
  result.damping_power += tread_.tangential_damping * deflection_rate.squaredNorm();
  if (result.end.sliding) {
    result.sliding_power = -patch.dot(slip);
    result.slip_speed = slip.head<2>().norm();
  } else {
    result.damping_power += -patch.dot(slip);  // zero but for rounding
  }

  const double roll_limit = tread_.rolling_friction_length * n.force;
  const auto roll = roll_.evaluate(stage.start.roll_deflection, u[4], roll_limit, stage.tau);
  result.end.roll_deflection = roll.deflection;
  result.end.rolling = roll.slips;
  const double elastic_rate = (roll.deflection - stage.start.roll_deflection) / stage.tau;
  result.rolling_power = -roll.torque * (u[4] - elastic_rate);
  return result;
}

double TreadLaw::spring_rates(const Stage& stage, const Vector5& u, const Result& result) const {
  const Vector3 rate = (result.end.deflection - stage.start.deflection) / stage.tau;
  const double roll = (result.end.roll_deflection - stage.start.roll_deflection) / stage.tau;
  const double normal = result.compression > 0 ? u[2] : 0;
  return tread_.normal_stiffness * normal * normal +
         tread_.tangential_stiffness * rate.squaredNorm() + roll_.stiffness * roll * roll;
}

double TreadLaw::stored_energy(double compression, const TreadState& state) const {
  const double d = std::max(compression, 0.0);
  return 0.5 * tread_.normal_stiffness * d * d +
         0.5 * tread_.tangential_stiffness * state.deflection.squaredNorm() +
         0.5 * roll_.stiffness * state.roll_deflection * state.roll_deflection;
}

}  // namespace gurney
