#include "engine/contact/tread_law.h"

#include <algorithm>

namespace gurney {
namespace {

TreadRates<double> rates_of(const Vector5& u) { return {{u[0], u[1], u[3]}, u[2], u[4]}; }

}  // namespace

TreadLaw::TreadLaw(const Tread& tread, double wheel_radius)
    : tread_(tread),
      constants_{
          tread.normal_stiffness,
          tread.normal_damping,
          tread.tangential_stiffness,
          tread.tangential_damping,
          tread.relaxation_length,
          tread.rolling_friction_length,
          tread.patch_width / 4,
          {kStickStiffnessRatio * tread.tangential_stiffness * wheel_radius * wheel_radius, 0}} {}

TreadStage<double> TreadLaw::inputs(const Stage& stage) const {
  TreadStage<double> result;
  result.tau = stage.tau;
  result.compression = stage.compression;
  result.mu = friction(stage.start);
  result.deflection = splat<double>(stage.start.deflection);
  result.roll_deflection = stage.start.roll_deflection;
  result.set_rolling(constants_, stage.rolling_speed);
  return result;
}

Vector5 TreadLaw::force(const Stage& stage, const Vector5& u, Matrix5& slope) const {
  TreadForce<double> f;
  TreadSlope<double> s;
  tread_force(constants_, inputs(stage), rates_of(u), f, s);
  const auto& [x, y, z] = s.patch;
  slope << x.x, y.x, s.by_normal.x, z.x, 0,  //
      x.y, y.y, s.by_normal.y, z.y, 0,       //
      0, 0, s.normal, 0, 0,                  //
      x.z, y.z, s.by_normal.z, z.z, 0,       //
      0, 0, s.roll_by_normal, 0, s.roll;
  return (Vector5() << f.patch.x, f.patch.y, f.normal, f.patch.z, f.roll).finished();
}

TreadLaw::Result TreadLaw::finish(const Stage& stage, const Vector5& u,
                                  const Vector5& force) const {
  const TreadForce<double> f{{force[0], force[1], force[3]}, force[2], force[4]};
  const auto o = tread_outcome(constants_, inputs(stage), rates_of(u), f);
  return {.force = force,
          .end = {.deflection = {o.deflection.x, o.deflection.y, o.deflection.z},
                  .roll_deflection = o.roll_deflection,
                  .sliding = o.slides,
                  .rolling = o.rolls},
          .compression = o.compression,
          .compression_rate = o.compression_rate,
          .sliding_power = o.sliding_power,
          .rolling_power = o.rolling_power,
          .relaxation_power = o.relaxation_power,
          .damping_power = o.damping_power,
          .slip_speed = o.slip_speed,
          .spring_rates = o.spring_rates};
}

}  // namespace gurney
