#include "engine/solver/caster_lanes.h"

#include <algorithm>

namespace gurney {
CasterLanes::CasterLanes(const Mechanism& mechanism, std::size_t first)
    : first_(first), count_(std::min(kLanes, mechanism.casters.size() - first)) {
  for (std::size_t k = 0; k < kLanes; ++k) {
    const CasterDynamics& caster = mechanism.casters[first + std::min(k, count_ - 1)];
    casters_[k] = &caster;
    set_lane(body_, k, caster.constants());
    set_lane(tread_, k, caster.tread().constants());
    set_lane(swivel_, k, caster.swivel_friction());
    set_lane(axle_, k, caster.axle_friction());
    swivel_limit_[k] = caster.swivel_limit();
  }
  cosines_.fill(1);
}

[[gnu::always_inline]] inline TreadRates<Lanes> CasterLanes::rates_of(const Velocity& v) const {
  return contact_rates<Lanes>(geometry_, body_.spin_radius,
                              {splat<Lanes>(v.chassis), joint_rates(v, 0), joint_rates(v, 1)});
}

/// Member by member, as numbers in registers: copied as a block they would be read back with a wait.
[[gnu::always_inline]] inline void CasterLanes::keep_result(
    const DryFrictionOf<Lanes>::Result& result, DryFrictionOf<Lanes>::Result& kept) {
  kept.torque = result.torque;
  kept.rate_slope = result.rate_slope;
  kept.deflection = result.deflection;
  kept.slips = result.slips;
}

void CasterLanes::set_swivel_angles(const State& start, double tau, const Velocity& v) {
  for (std::size_t k = 0; k < count_; ++k) {
    const double angle = start.casters[first_ + k].swivel_angle + tau * v.joints[first_ + k][0];
    if (angle == swivel_angles_[k]) continue;  // of a fork that does not swivel
    swivel_angles_[k] = angle;
    sines_[k] = std::sin(angle);
    cosines_[k] = std::cos(angle);
  }
  motion_.sine = gather([&](std::size_t k) { return sines_[k]; });
  motion_.cosine = gather([&](std::size_t k) { return cosines_[k]; });
}

void CasterLanes::update_geometry(const State& start, double tau, const Velocity& v,
                                  const Pose& pose, const Vector3& gravity, bool first_pass) {
  kept_ = LaneMask{};
  set_swivel_angles(start, tau, v);
  motion_.rotation = splat<Lanes>(pose.rotation);
  motion_.height = splat<Lanes>(pose.position.z());
  motion_.angular_velocity = splat<Lanes>(Vector3(v.chassis.tail<3>()));
  motion_.swivel_rate = joint_rates(v, 0);
  motion_.axle_rate = joint_rates(v, 1);
  motion_.gravity = splat<Lanes>(gravity);
  caster_geometry(body_, motion_, geometry_);

  const TreadRates<Lanes> u = rates_of(v);
  stage_.tau = splat<Lanes>(tau);
  // At zero rate: it ends at compression - tau u_n.
  stage_.compression = -geometry_.height + stage_.tau * u.normal;
  const CasterState* casters = start.casters.data() + first_;
  const auto of_tread = [&](const auto& number) {
    return gather([&](std::size_t k) -> double { return number(casters[k].tread); });
  };
  stage_.mu =
      gather([&](std::size_t k) { return casters_[k]->tread().friction(casters[k].tread); });
  stage_.deflection = {of_tread([](const TreadState& t) { return t.deflection[0]; }),
                       of_tread([](const TreadState& t) { return t.deflection[1]; }),
                       of_tread([](const TreadState& t) { return t.deflection[2]; })};
  stage_.roll_deflection = of_tread([](const TreadState& t) { return t.roll_deflection; });
  axle_limit_ =
      gather([&](std::size_t k) { return casters_[k]->axle_limit(casters[k].axle_slips); });
  swivel_wind_ = gather([&](std::size_t k) { return casters[k].swivel_wind; });
  axle_wind_ = gather([&](std::size_t k) { return casters[k].axle_wind; });
  // Whether the patch rolls through is decided by its memory, then by the pass before: the slope of a moment at its
  // limit is 0.
  const LaneMask rolls =
      first_pass ? of_tread([](const TreadState& t) { return t.rolling ? 1 : 0; }) > Lanes{}
                 : abs(slope_.roll) == Lanes{};
  stage_.set_rolling(tread_, select(rolls, body_.radius * abs(u.roll), Lanes{}));
}

std::array<Lanes, 20> CasterLanes::inertia_and_bias() const {
  const CasterGeometry<Lanes>& g = geometry_;
  const auto& [x, y, z] = g.inertia;
  return {g.mass_moment.x,
          g.mass_moment.y,
          g.mass_moment.z,
          x.x,
          x.y,
          x.z,
          y.x,
          y.y,
          y.z,
          z.x,
          z.y,
          z.z,
          g.bias_linear.x,
          g.bias_linear.y,
          g.bias_linear.z,
          g.bias_angular.x,
          g.bias_angular.y,
          g.bias_angular.z,
          Lanes{},
          Lanes{}};
}

Vec6<Lanes> CasterLanes::coupled_momentum(const Lanes& swivel, const Lanes& axle) const {
  const CasterGeometry<Lanes>& g = geometry_;
  return {swivel * g.coupling_linear, mul_add(axle, g.spin_momentum, swivel * g.coupling_angular)};
}

void CasterLanes::evaluate_forces(const State& start, double tau, const Velocity& v,
                                  const Vector6& chassis_change) {
  const TreadRates<Lanes> u = rates_of(v);
  rates_.patch = u.patch;
  rates_.normal = u.normal;
  rates_.roll = u.roll;
  tread_force(tread_, stage_, u, force_, slope_);
  const Lanes swivel_rate = joint_rates(v, 0), axle_rate = joint_rates(v, 1);
  keep_result(swivel_.evaluate(swivel_wind_, swivel_rate, swivel_limit_, stage_.tau),
              swivel_friction_);
  keep_result(axle_.evaluate(axle_wind_, axle_rate, axle_limit_, stage_.tau), axle_friction_);

  // q = M_joints (v - v_start) - tau (J' f - bias + friction) of swivel and axle.
  const CasterGeometry<Lanes>& g = geometry_;
  const CasterVector<Lanes> f = generalised(g, body_.spin_radius, force_);
  const Lanes swivel_change = swivel_rate - joint_rates(start.velocity, 0);
  const Lanes axle_change = axle_rate - joint_rates(start.velocity, 1);
  const Vec6<Lanes> change = splat<Lanes>(chassis_change);
  const Lanes on_swivel =
      f.swivel - g.bias_swivel + select(body_.swivels > 0.0, swivel_friction_.torque, Lanes{});
  const Lanes on_axle = f.axle - g.bias_axle + axle_friction_.torque;
  joint_residual_ = {
      dot(Vec6<Lanes>{g.coupling_linear, g.coupling_angular}, change) +
          (g.joint_inertia * swivel_change + g.joint_coupling * axle_change) - tau * on_swivel,
      dot(g.spin_momentum, change.angular) +
          (g.joint_coupling * swivel_change + body_.axial_inertia * axle_change) - tau * on_axle};
  const std::array<Lanes, 6> force = entries(f.chassis);
  const std::array<Lanes, 6> momentum = entries(coupled_momentum(swivel_change, axle_change));
  for (std::size_t i = 0; i < 6; ++i) {
    on_chassis_[i] = force[i];
    on_chassis_[6 + i] = momentum[i];
  }
}

double CasterLanes::largest_joint_residual() const {
  const Lanes swivel = abs(joint_residual_[0]), axle = abs(joint_residual_[1]);
  // 0 axle: an axle that is no number counts, too.
  const Lanes larger = (select(swivel < axle, axle, swivel) + 0.0 * axle) / body_.radius;
  double largest = 0;
  for (std::size_t k = 0; k < count_; ++k) largest = larger_or_nan(largest, larger[k]);
  return largest;
}

Eigen::Vector2d CasterLanes::joint_residual(std::size_t k) const {
  return {joint_residual_[0][k], joint_residual_[1][k]};
}

void CasterLanes::add_joint_residual(std::size_t k, const Eigen::Vector2d& residual) {
  joint_residual_[0][k] += residual[0];
  joint_residual_[1][k] += residual[1];
}

}  // namespace gurney
