#include <algorithm>

#include "engine/solver/caster_lanes.h"

// K = M + tau J' D J of the casters and the elimination of their joints.
namespace gurney {
namespace {

TreadSlope<Lanes> scaled(const Lanes& tau, const TreadSlope<Lanes>& d) {
  return {tau * d.patch, tau * d.by_normal, tau * d.normal, tau * d.roll_by_normal, tau * d.roll};
}

}  // namespace

std::array<Lanes, 36> CasterLanes::matrix(double tau) {
  const CasterGeometry<Lanes>& g = geometry_;
  const TreadSlope<Lanes> d = scaled(splat<Lanes>(tau), slope_);
  const Lanes no{}, r_s = body_.spin_radius;
  const Vec3<Lanes>&p = g.contact, &l = g.axle_level;
  const auto column = [&](const TreadForce<Lanes>& by_rate) {
    return generalised(g, r_s, by_rate);
  };
  // Columns of D J, each under J'. A velocity of O moves the contact alike: columns of D.
  const std::array<CasterVector<Lanes>, 8> k = {
      column({d.patch.x, no, no}),
      column({d.patch.y, no, no}),
      column({d.by_normal, d.normal, d.roll_by_normal}),
      column(d * TreadRates<Lanes>{{no, -p.z, no}, p.y, l.x}),
      column(d * TreadRates<Lanes>{{p.z, no, no}, -p.x, l.y}),
      column(d * TreadRates<Lanes>{{-p.y, p.x, r_s}, no, l.z}),
      column(d * TreadRates<Lanes>{{g.swivel_speed.x, g.swivel_speed.y, g.swivel_spin},
                                   g.swivel_speed.z,
                                   g.swivel_roll}),
      column(d * TreadRates<Lanes>{
                     {g.axle_speed.x, g.axle_speed.y, g.axle_spin}, g.axle_speed.z, g.axle_roll})};
  const Vec6<Lanes> swivel_mass{g.coupling_linear, g.coupling_angular};
  const Vec6<Lanes> axle_mass{{}, g.spin_momentum};
  chassis_joints_ = {swivel_mass + k[6].chassis, axle_mass + k[7].chassis};
  joints_chassis_ = {swivel_mass + Vec6<Lanes>{{k[0].swivel, k[1].swivel, k[2].swivel},
                                               {k[3].swivel, k[4].swivel, k[5].swivel}},
                     axle_mass + Vec6<Lanes>{{k[0].axle, k[1].axle, k[2].axle},
                                             {k[3].axle, k[4].axle, k[5].axle}}};
  const Lanes swivel_friction = select(body_.swivels > 0.0, tau * swivel_friction_.rate_slope, no);
  joints_ = {std::array<Lanes, 2>{g.joint_inertia + k[6].swivel + swivel_friction,
                                  g.joint_coupling + k[6].axle},
             {g.joint_coupling + k[7].swivel,
              body_.axial_inertia + k[7].axle + tau * axle_friction_.rate_slope}};
  std::array<Lanes, 36> chassis;
  for (std::size_t j = 0; j < 6; ++j)
    std::ranges::copy(entries(k[j].chassis), chassis.begin() + 6 * static_cast<int>(j));
  return chassis;
}

void CasterLanes::eliminate() {
  const auto& [e0, e1] = joints_;  // columns of E
  // E of swivel and axle is 2 x 2: its inverse in closed form.
  const Lanes inverse = 1.0 / (e0[0] * e1[1] - e0[1] * e1[0]);
  inverse_ = {std::array<Lanes, 2>{e1[1] * inverse, -e0[1] * inverse},
              {-e1[0] * inverse, e0[0] * inverse}};
  const JointVectors &b = chassis_joints_, &c = joints_chassis_;
  const auto taken = [&](std::size_t k) {  // a column of B E^-1
    return mul_add(inverse_[k][1], b[1], inverse_[k][0] * b[0]);
  };
  const Vec6<Lanes>&b0 = taken_[0] = taken(0), &b1 = taken_[1] = taken(1);
  const std::array<Lanes, 6> c0 = entries(c[0]), c1 = entries(c[1]);
  Elimination& result = elimination_;
  for (std::size_t j = 0; j < 6; ++j)
    std::ranges::copy(entries(-mul_add(c1[j], b1, c0[j] * b0)),
                      result.matrix.begin() + 6 * static_cast<int>(j));
  // Casters that touch another item keep their joints in the common system, and take nothing from the chassis here.
  if (!any(kept_)) return;
  for (Lanes& entry : result.matrix) entry = select(kept_, Lanes{}, entry);
}

void CasterLanes::eliminate_residual() {
  std::ranges::copy(entries(mul_add(joint_residual_[1], taken_[1], joint_residual_[0] * taken_[0])),
                    elimination_.right_side.begin());
  if (!any(kept_)) return;
  for (Lanes& entry : elimination_.right_side) entry = select(kept_, Lanes{}, entry);
}

void CasterLanes::apply(const Vector6& step, Velocity& v) const {
  const Vec6<Lanes> x = splat<Lanes>(step);
  // y = -E^-1 (q + C x).
  const Lanes q0 = joint_residual_[0] + dot(joints_chassis_[0], x);
  const Lanes q1 = joint_residual_[1] + dot(joints_chassis_[1], x);
  const Lanes swivel = inverse_[0][0] * q0 + inverse_[1][0] * q1;
  const Lanes axle = inverse_[0][1] * q0 + inverse_[1][1] * q1;
  for (std::size_t k = 0; k < count_; ++k) {
    if (kept(k)) continue;
    v.joints[first_ + k][0] -= swivel[k];
    v.joints[first_ + k][1] -= axle[k];
  }
}

Matrix2 CasterLanes::joints(std::size_t k) const {
  Matrix2 result;
  result << joints_[0][0][k], joints_[1][0][k], joints_[0][1][k], joints_[1][1][k];
  return result;
}

Eigen::Matrix<double, 6, 2> CasterLanes::chassis_joints(std::size_t k) const {
  Eigen::Matrix<double, 6, 2> result;
  result << lane(chassis_joints_[0].linear, k), lane(chassis_joints_[1].linear, k),
      lane(chassis_joints_[0].angular, k), lane(chassis_joints_[1].angular, k);
  return result;
}

Eigen::Matrix<double, 2, 6> CasterLanes::joints_chassis(std::size_t k) const {
  Eigen::Matrix<double, 2, 6> result;
  for (int i = 0; i < 2; ++i) {
    const Vec6<Lanes>& row = joints_chassis_[static_cast<std::size_t>(i)];
    result.row(i) << lane(row.linear, k).transpose(), lane(row.angular, k).transpose();
  }
  return result;
}

void CasterLanes::add_slopes(std::size_t k, const Eigen::Matrix<double, 6, 2>& chassis_joints,
                             const Eigen::Matrix<double, 2, 6>& joints_chassis,
                             const Matrix2& joints) {
  const auto add = [k](Vec3<Lanes>& to, const Vector3& v) { set_lane(to, k, lane(to, k) + v); };
  for (int i = 0; i < 2; ++i) {
    const auto joint = static_cast<std::size_t>(i);
    add(chassis_joints_[joint].linear, chassis_joints.col(i).head<3>());
    add(chassis_joints_[joint].angular, chassis_joints.col(i).tail<3>());
    add(joints_chassis_[joint].linear, joints_chassis.row(i).head<3>());
    add(joints_chassis_[joint].angular, joints_chassis.row(i).tail<3>());
    for (int row = 0; row < 2; ++row)
      joints_[joint][static_cast<std::size_t>(row)][k] += joints(row, i);
  }
}

}  // namespace gurney
