#include "engine/solver/caster_lanes.h"

// Changes of the casters by a finished stage.
namespace gurney {
namespace {

struct CasterJoint {
  Lanes rate, wind, end;  ///< wind: at the start of the stage, end: at its end [rad]
};

/// Power that dry and viscous friction take (W), and k z'^2 (W/s).
struct CasterJointOutcome {
  Lanes loss, spring_rates;
};

CasterJointOutcome outcome_of(const DryFrictionOf<Lanes>& friction, const CasterJoint& joint,
                              const Lanes& tau) {
  const Lanes wind_rate = (joint.end - joint.wind) / tau;
  const Lanes dry = -friction.stiffness * joint.end;
  return {friction.viscous * joint.rate * joint.rate - dry * (joint.rate - wind_rate),
          friction.stiffness * wind_rate * wind_rate};
}

void add(const Lanes& values, std::size_t count, double& sum) {
  for (std::size_t k = 0; k < count; ++k) sum += values[k];
}

}  // namespace

void CasterLanes::finish(const State& start, double length, const Velocity& v,
                         const Vector6& acceleration, State& end, const Outputs& out,
                         const Sums& sums) const {
  const CasterGeometry<Lanes>& g = geometry_;
  const Lanes tau = splat<Lanes>(length);
  const TreadOutcome<Lanes> tread = tread_outcome(tread_, stage_, rates_, force_);
  const Lanes swivel_rate = joint_rates(v, 0), axle_rate = joint_rates(v, 1);
  const Lanes b0 = (swivel_rate - joint_rates(start.velocity, 0)) / tau;
  const Lanes b1 = (axle_rate - joint_rates(start.velocity, 1)) / tau;

  // 2 a' M b + b' M b of the joints' accelerations b beside that of the chassis, a.
  const Lanes joint0 = g.joint_inertia * b0 + g.joint_coupling * b1;
  const Lanes joint1 = g.joint_coupling * b0 + body_.axial_inertia * b1;
  const Lanes inertial_rates =
      2.0 * dot(splat<Lanes>(acceleration), coupled_momentum(b0, b1)) + (b0 * joint0 + b1 * joint1);

  const CasterJointOutcome swivel =
      outcome_of(swivel_, {swivel_rate, swivel_wind_, swivel_friction_.deflection}, tau);
  const CasterJointOutcome axle =
      outcome_of(axle_, {axle_rate, axle_wind_, axle_friction_.deflection}, tau);
  const Lanes spring_rates = swivel.spring_rates + axle.spring_rates + tread.spring_rates;

  // m v + w x m r + psi' m d.
  const Vec6<Lanes> V = splat<Lanes>(v.chassis);
  const Vec3<Lanes> momentum =
      body_.mass * V.linear + cross(V.angular, g.mass_moment) + swivel_rate * g.coupling_linear;

  for (std::size_t k = 0; k < count_; ++k) {
    sums.spring_rates += inertial_rates[k];
    sums.spring_rates += spring_rates[k];
    sums.momentum += lane(momentum, k);
    const std::size_t i = first_ + k;
    const CasterState& was = start.casters[i];
    CasterState& is = end.casters[i];
    is.swivel_angle = was.swivel_angle + length * swivel_rate[k];
    is.axle_angle = was.axle_angle + length * axle_rate[k];
    is.tread = {lane(tread.deflection, k), tread.roll_deflection[k], tread.slides[k] != 0,
                tread.rolls[k] != 0};
    is.swivel_wind = swivel_friction_.deflection[k];
    is.axle_wind = axle_friction_.deflection[k];
    is.axle_slips = axle_friction_.slips[k] != 0;
    TreadLaw::Result& result = out.treads[k];
    result.force << force_.patch.x[k], force_.patch.y[k], force_.normal[k], force_.patch.z[k],
        force_.roll[k];
    result.end = is.tread;
    result.compression = tread.compression[k];
    result.compression_rate = tread.compression_rate[k];
    result.sliding_power = tread.sliding_power[k];
    result.rolling_power = tread.rolling_power[k];
    result.relaxation_power = tread.relaxation_power[k];
    result.damping_power = tread.damping_power[k];
    result.slip_speed = tread.slip_speed[k];
    result.spring_rates = tread.spring_rates[k];
    out.heading[k] = lane(g.axle_level, k).cross(Vector3::UnitZ()).head<2>();
    out.accelerations[k] = {b0[k], b1[k]};
  }
  EnergyAccount& power = sums.power;
  add(tread.rolling_power, count_, power.rolling_loss);
  add(tread.sliding_power, count_, power.sliding_loss);
  add(tread.relaxation_power, count_, power.relaxation_loss);
  add(tread.damping_power, count_, power.tread_loss);
  add(select(body_.swivels > 0.0, swivel.loss, Lanes{}), count_, power.swivel_loss);
  add(axle.loss, count_, power.axle_loss);
}

}  // namespace gurney
