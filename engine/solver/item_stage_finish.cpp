#include <cmath>

#include "engine/solver/item_stage.h"

namespace gurney {

Vector6 ItemStage::all_momentum(const Velocity& v) const {
  Vector6 momentum = mass_ * v.chassis;
  for (std::size_t i = 0; i < mechanism_.casters.size(); ++i)
    momentum += casters_[i].g.mass_coupling * v.joints[i];
  return momentum;
}

void ItemStage::finish(const Input& input, const Velocity& v, State& end, Output& out) const {
  const State& start = *input.start;
  const double tau = input.tau;
  EnergyAccount& power = out.power;
  power = EnergyAccount();

  end.position = start.position + tau * v.chassis.head<3>();
  end.rotation = rotated(tau * v.chassis.tail<3>(), start.rotation);
  end.velocity = v;
  out.acceleration.chassis = (v.chassis - start.velocity.chassis) / tau;

  const Vector6& a = out.acceleration.chassis;
  double rates = a.dot(mass_ * a);
  Vector3 momentum = mechanism_.chassis.mass * v.chassis.head<3>();
  for (std::size_t i = 0; i < mechanism_.casters.size(); ++i) {
    const CasterDynamics& caster = mechanism_.casters[i];
    const CasterWork& work = casters_[i];
    const CasterState& was = start.casters[i];
    CasterState& is = end.casters[i];
    const Eigen::Vector2d& q = v.joints[i];
    out.acceleration.joints[i] = (q - start.velocity.joints[i]) / tau;
    const Eigen::Vector2d& b = out.acceleration.joints[i];
    rates += 2 * a.dot(work.g.mass_coupling * b) + b.dot(work.g.mass_joints * b);
    momentum +=
        work.g.mass_chassis.topRows<3>() * v.chassis + work.g.mass_coupling.topRows<3>() * q;

    is.swivel_angle = was.swivel_angle + tau * q[0];
    is.axle_angle = was.axle_angle + tau * q[1];
    out.treads[i] = caster.tread().finish(work.tread, work.rates, work.force);
    const TreadLaw::Result& tread = out.treads[i];
    is.tread = tread.end;
    is.swivel_wind = work.swivel.deflection;
    is.axle_wind = work.axle.deflection;
    out.axle_slips[i] = work.axle.slips;
    out.heading[i] = work.g.heading.head<2>();

    power.rolling_loss += tread.rolling_power;
    power.sliding_loss += tread.sliding_power;
    power.relaxation_loss += tread.relaxation_power;
    power.tread_loss += tread.damping_power;
    const double swivel_wind_rate = (is.swivel_wind - was.swivel_wind) / tau;
    const double axle_wind_rate = (is.axle_wind - was.axle_wind) / tau;
    const double swivel_dry = -caster.swivel_friction().stiffness * is.swivel_wind;
    const double axle_dry = -caster.axle_friction().stiffness * is.axle_wind;
    if (caster.swivels())
      power.swivel_loss +=
          caster.swivel_friction().viscous * q[0] * q[0] - swivel_dry * (q[0] - swivel_wind_rate);
    power.axle_loss +=
        caster.axle_friction().viscous * q[1] * q[1] - axle_dry * (q[1] - axle_wind_rate);
    rates += caster.swivel_friction().stiffness * swivel_wind_rate * swivel_wind_rate +
             caster.axle_friction().stiffness * axle_wind_rate * axle_wind_rate +
             caster.tread().spring_rates(work.tread, work.rates, tread);
  }
  power.work_of_floor = -input.floor.acceleration.dot(momentum);
  if (input.floor.rotates) power.work_of_floor -= carried_.dot(all_momentum(v));
  for (int dof = 0; dof < 6; ++dof) {
    const Guide& guide = mechanism_.fixture.guides[dof];
    if (guide.kind == Guide::Kind::kVelocity)
      power.work_of_fixtures += reaction_[static_cast<std::size_t>(dof)] / tau * v.chassis[dof];
  }

  if (mechanism_.loads.empty()) {
    end.loads = {};
  } else {
    rates += mechanism_.loads.finish(input.loads, pose_, v.chassis, power, end.loads);
  }
  end.broken_tethers = start.broken_tethers;
  if (!mechanism_.tethers.empty())
    rates += mechanism_.tethers.finish(tau, start, pose_, v.chassis, power);
  out.spring_rates = rates;
}

}  // namespace gurney
