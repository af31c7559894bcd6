#include "engine/solver/caster_lanes.h"

#include <algorithm>

namespace gurney {
namespace {

TreadRates<Lanes> tread_rates(const ContactRates<Lanes>& u) {
  return {{u.velocity.x, u.velocity.y, u.spin}, u.velocity.z, u.roll};
}

/// Of six products, as Eigen sums those of two vectors.
Lanes dot6(const CasterLanes::Six& a, const CasterLanes::Six& b) {
  return (a[0] * b[0] + (a[2] * b[2] + a[4] * b[4])) + (a[1] * b[1] + (a[3] * b[3] + a[5] * b[5]));
}

CasterLanes::Six same6(const Vector6& v) {
  CasterLanes::Six result;
  for (int i = 0; i < 6; ++i) result[static_cast<std::size_t>(i)] = same<Lanes>(v[i]);
  return result;
}

}  // namespace

CasterLanes::CasterLanes(const Mechanism& mechanism, std::size_t first)
    : first_(first), count_(std::min(kLanes, mechanism.casters.size() - first)) {
  for (std::size_t k = 0; k < kLanes; ++k) {
    const CasterDynamics& caster = mechanism.casters[first + std::min(k, count_ - 1)];
    laws_[k] = &caster.tread();
    set_lane(body_, k, caster.constants());
    set_lane(tread_, k, caster.tread().constants());
    set_lane(swivel_, k, caster.swivel_friction());
    set_lane(axle_, k, caster.axle_friction());
    swivel_limit_[k] = caster.swivel_limit();
    axle_limit_[k] = caster.axle_limit();
  }
  cosines_.fill(1);
}

[[gnu::always_inline]] inline ContactRates<Lanes> CasterLanes::rates_of(const Velocity& v) const {
  const Vector6& c = v.chassis;
  return contact_rates<Lanes>(geometry_, body_.spin_radius,
                              {same<Lanes>(c[0]), same<Lanes>(c[1]), same<Lanes>(c[2])},
                              {same<Lanes>(c[3]), same<Lanes>(c[4]), same<Lanes>(c[5])},
                              joint_rates(v, 0), joint_rates(v, 1));
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
  motion_.sine = gathered([&](std::size_t k) { return sines_[k]; });
  motion_.cosine = gathered([&](std::size_t k) { return cosines_[k]; });
}

void CasterLanes::update_geometry(const State& start, double tau, const Velocity& v,
                                  const Pose& pose, const Vector3& gravity, bool first_pass) {
  kept_ = LaneMask{};
  set_swivel_angles(start, tau, v);
  motion_.rotation = same<Lanes>(pose.rotation);
  motion_.height = same<Lanes>(pose.position.z());
  motion_.angular_velocity = same<Lanes>(Vector3(v.chassis.tail<3>()));
  motion_.swivel_rate = joint_rates(v, 0);
  motion_.axle_rate = joint_rates(v, 1);
  motion_.gravity = same<Lanes>(gravity);
  caster_geometry(body_, motion_, geometry_);

  const ContactRates<Lanes> u = rates_of(v);
  stage_.tau = same<Lanes>(tau);
  stage_.compression = -geometry_.height + stage_.tau * u.velocity.z;
  const CasterState* casters = start.casters.data() + first_;
  const auto of_tread = [&](const auto& number) {
    return gathered([&](std::size_t k) -> double { return number(casters[k].tread); });
  };
  stage_.mu = gathered([&](std::size_t k) { return laws_[k]->friction(casters[k].tread); });
  stage_.deflection = {of_tread([](const TreadState& t) { return t.deflection[0]; }),
                       of_tread([](const TreadState& t) { return t.deflection[1]; }),
                       of_tread([](const TreadState& t) { return t.deflection[2]; })};
  stage_.roll_deflection = of_tread([](const TreadState& t) { return t.roll_deflection; });
  swivel_wind_ = gathered([&](std::size_t k) { return casters[k].swivel_wind; });
  axle_wind_ = gathered([&](std::size_t k) { return casters[k].axle_wind; });
  const LaneMask rolls =
      first_pass ? of_tread([](const TreadState& t) { return t.rolling ? 1 : 0; }) > Lanes{}
                 : magnitude(slope_.roll) == Lanes{};
  stage_.set_rolling(tread_, select(rolls, body_.radius * magnitude(u.roll), Lanes{}));
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

CasterLanes::Six CasterLanes::coupled_momentum(const Lanes& swivel, const Lanes& axle) const {
  const CasterGeometry<Lanes>& g = geometry_;
  const Triple<Lanes>& linear = g.coupling_linear;
  const Triple<Lanes>&angular = g.coupling_angular, &spin = g.spin_momentum;
  return {linear.x * swivel,
          linear.y * swivel,
          linear.z * swivel,
          madd(spin.x, axle, angular.x * swivel),
          madd(spin.y, axle, angular.y * swivel),
          madd(spin.z, axle, angular.z * swivel)};
}

void CasterLanes::evaluate_forces(const State& start, double tau, const Velocity& v,
                                  const Vector6& chassis_change) {
  const ContactRates<Lanes> u = rates_of(v);
  rates_.velocity = {u.velocity.x, u.velocity.y, u.velocity.z};
  rates_.spin = u.spin;
  rates_.roll = u.roll;
  tread_force(tread_, stage_, tread_rates(u), force_, slope_);
  const Lanes swivel_rate = joint_rates(v, 0), axle_rate = joint_rates(v, 1);
  keep_result(swivel_.evaluate(swivel_wind_, swivel_rate, swivel_limit_, stage_.tau),
              swivel_friction_);
  keep_result(axle_.evaluate(axle_wind_, axle_rate, axle_limit_, stage_.tau), axle_friction_);

  const CasterGeometry<Lanes>& g = geometry_;
  const std::array<Lanes, 8> f =
      generalised(g, body_.spin_radius,
                  {force_.patch.x, force_.patch.y, force_.normal, force_.patch.z, force_.roll});
  const Lanes swivel_change = swivel_rate - joint_rates(start.velocity, 0);
  const Lanes axle_change = axle_rate - joint_rates(start.velocity, 1);
  const Six m = coupled_momentum(swivel_change, axle_change);

  const Six change = same6(chassis_change);
  const Lanes no = Lanes{};
  const Lanes on_swivel =
      f[6] - g.bias_swivel + select(body_.swivels > no, swivel_friction_.torque, no);
  const Lanes on_axle = f[7] - g.bias_axle + axle_friction_.torque;
  const Triple<Lanes>&linear = g.coupling_linear, &angular = g.coupling_angular;
  joint_residual_ = {
      dot6({linear.x, linear.y, linear.z, angular.x, angular.y, angular.z}, change) +
          madd(g.joint_coupling, axle_change, g.joint_inertia * swivel_change) - tau * on_swivel,
      dot6({no, no, no, g.spin_momentum.x, g.spin_momentum.y, g.spin_momentum.z}, change) +
          madd(body_.axial_inertia, axle_change, g.joint_coupling * swivel_change) - tau * on_axle};
  on_chassis_ = {f[0], f[1], f[2], f[3], f[4], f[5], m[0], m[1], m[2], m[3], m[4], m[5]};
}

double CasterLanes::largest_joint_residual() const {
  const Lanes swivel = magnitude(joint_residual_[0]), axle = magnitude(joint_residual_[1]);
  const Lanes larger = select(swivel < axle, axle, swivel) / body_.radius;
  double largest = 0;
  for (std::size_t k = 0; k < count_; ++k) largest = std::max(largest, larger[k]);
  return largest;
}

Eigen::Vector2d CasterLanes::joint_residual(std::size_t lane) const {
  return {joint_residual_[0][lane], joint_residual_[1][lane]};
}

void CasterLanes::add_joint_residual(std::size_t lane, const Eigen::Vector2d& residual) {
  joint_residual_[0][lane] += residual[0];
  joint_residual_[1][lane] += residual[1];
}

}  // namespace gurney
