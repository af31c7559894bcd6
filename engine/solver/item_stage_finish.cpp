#include <cmath>

#include "engine/solver/item_stage.h"

namespace gurney {

Vector6 ItemStage::all_momentum(const Velocity& v) const {
  Vector6 momentum = mass_ * v.chassis;
  for (const CasterLanes& lanes : casters_) {
    const Vec6<Lanes> joints = lanes.joint_momentum(v);
    for (std::size_t k = 0; k < lanes.count(); ++k) {
      momentum.head<3>() += lane(joints.linear, k);
      momentum.tail<3>() += lane(joints.angular, k);
    }
  }
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

  // a' M a: what the method of second order loses or gains of kinetic energy (EnergyAccount::numerical_loss).
  const Vector6& a = out.acceleration.chassis;
  double rates = a.dot(mass_ * a);
  Vector3 momentum = mechanism_.chassis.mass * v.chassis.head<3>();
  for (const CasterLanes& lanes : casters_) {
    const std::size_t i = lanes.first();
    lanes.finish(start, tau, v, a, end,
                 {&out.treads[i], &out.heading[i], &out.acceleration.joints[i]},
                 {power, rates, momentum});
  }
  // Power of the force -m x'' that the floor's acceleration is in its axes.
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
    rates += mechanism_.loads.finish(input.loads, pose_, v.chassis, load_rows_, power, end.loads);
  }
  end.broken_tethers = start.broken_tethers;
  if (!mechanism_.tethers.empty())
    rates += mechanism_.tethers.finish(tau, start, pose_, v.chassis, power);
  out.spring_rates = rates;
}

}  // namespace gurney
