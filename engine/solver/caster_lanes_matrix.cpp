#include "engine/solver/caster_lanes.h"

// K = M + tau J' D J of the casters and its joints' elimination.
namespace gurney {
namespace {

using Column = ContactForces<Lanes>;

/// The columns of D J, forces by a velocity of the chassis or a joint, after the first three, which
/// are those of D.
struct Columns5 {
  Column turn_x, turn_y, turn_z, swivel, axle;
};

Columns5 columns(const TreadSlope<Lanes>& d, const CasterGeometry<Lanes>& g,
                 const Lanes& spin_radius) {
  const Triple<Lanes>&p = g.contact, &level = g.axle_level;
  const auto joint = [&](const Triple<Lanes>& v, const Lanes& spin, const Lanes& roll) -> Column {
    const auto row = [&](const Lanes& by_x, const Lanes& by_y, const Lanes& by_normal,
                         const Lanes& by_spin) {
      return madd(by_spin, spin, madd(by_normal, v.z, madd(by_y, v.y, by_x * v.x)));
    };
    return {row(d.patch.x.x, d.patch.y.x, d.by_normal.x, d.patch.z.x),
            row(d.patch.x.y, d.patch.y.y, d.by_normal.y, d.patch.z.y), d.normal * v.z,
            row(d.patch.x.z, d.patch.y.z, d.by_normal.z, d.patch.z.z),
            d.roll_by_normal * v.z + d.roll * roll};
  };
  const auto turn_x = [&](const Lanes& by_y, const Lanes& by_normal) {
    return madd(by_normal, p.y, by_y * -p.z);
  };
  const auto turn_y = [&](const Lanes& by_x, const Lanes& by_normal) {
    return madd(by_normal, -p.x, by_x * p.z);
  };
  const auto turn_z = [&](const Lanes& by_x, const Lanes& by_y, const Lanes& by_spin) {
    return madd(by_spin, spin_radius, madd(by_y, p.x, by_x * -p.y));
  };
  const auto& [x, y, spin] = d.patch;
  return {{turn_x(y.x, d.by_normal.x), turn_x(y.y, d.by_normal.y), d.normal * p.y,
           turn_x(y.z, d.by_normal.z), d.roll_by_normal * p.y + d.roll * level.x},
          {turn_y(x.x, d.by_normal.x), turn_y(x.y, d.by_normal.y), d.normal * -p.x,
           turn_y(x.z, d.by_normal.z), d.roll_by_normal * -p.x + d.roll * level.y},
          {turn_z(x.x, y.x, spin.x), turn_z(x.y, y.y, spin.y), Lanes{}, turn_z(x.z, y.z, spin.z),
           d.roll * level.z},
          joint(g.swivel_speed, g.swivel_spin, g.swivel_roll),
          joint(g.axle_speed, g.axle_spin, g.axle_roll)};
}

TreadSlope<Lanes> scaled(const Lanes& tau, const TreadSlope<Lanes>& d) {
  return {{tau * d.patch.x, tau * d.patch.y, tau * d.patch.z},
          tau * d.by_normal,
          tau * d.normal,
          tau * d.roll_by_normal,
          tau * d.roll};
}

}  // namespace

std::array<Lanes, 36> CasterLanes::matrix(double length) {
  const CasterGeometry<Lanes>& g = geometry_;
  const Lanes tau = same<Lanes>(length);
  const TreadSlope<Lanes> d = scaled(tau, slope_);
  const Columns5 c = columns(d, g, body_.spin_radius);
  const Lanes no = Lanes{};
  const std::array<std::array<Lanes, 8>, 8> added = {
      generalised(g, body_.spin_radius, {d.patch.x.x, d.patch.x.y, no, d.patch.x.z, no}),
      generalised(g, body_.spin_radius, {d.patch.y.x, d.patch.y.y, no, d.patch.y.z, no}),
      generalised(g, body_.spin_radius,
                  {d.by_normal.x, d.by_normal.y, d.normal, d.by_normal.z, d.roll_by_normal}),
      generalised(g, body_.spin_radius, c.turn_x),
      generalised(g, body_.spin_radius, c.turn_y),
      generalised(g, body_.spin_radius, c.turn_z),
      generalised(g, body_.spin_radius, c.swivel),
      generalised(g, body_.spin_radius, c.axle)};
  const Triple<Lanes>&linear = g.coupling_linear, &angular = g.coupling_angular;
  const Triple<Lanes>& spin = g.spin_momentum;
  const SixByTwo mass = {Six{linear.x, linear.y, linear.z, angular.x, angular.y, angular.z},
                         Six{no, no, no, spin.x, spin.y, spin.z}};
  std::array<Lanes, 36> chassis;
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j < 6; ++j) chassis[6 * j + i] = added[j][i];
    for (std::size_t k = 0; k < 2; ++k) {
      chassis_joints_[k][i] = mass[k][i] + added[6 + k][i];
      joints_chassis_[k][i] = mass[k][i] + added[i][6 + k];
    }
  }
  joints_ = {std::array<Lanes, 2>{g.joint_inertia + added[6][6], g.joint_coupling + added[6][7]},
             {g.joint_coupling + added[7][6], body_.axial_inertia + added[7][7]}};
  joints_[0][0] += select(body_.swivels > no, tau * swivel_friction_.rate_slope, no);
  joints_[1][1] += tau * axle_friction_.rate_slope;
  return chassis;
}

void CasterLanes::eliminate() {
  const auto& [first, second] = joints_;
  const Lanes inverse = same<Lanes>(1) / (first[0] * second[1] - first[1] * second[0]);
  inverse_ = {std::array<Lanes, 2>{second[1] * inverse, -first[1] * inverse},
              {-second[0] * inverse, first[0] * inverse}};
  SixByTwo taken;
  for (std::size_t k = 0; k < 2; ++k)
    for (std::size_t i = 0; i < 6; ++i)
      taken[k][i] =
          madd(chassis_joints_[1][i], inverse_[k][1], chassis_joints_[0][i] * inverse_[k][0]);
  Elimination& result = elimination_;
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j < 6; ++j)
      result.matrix[6 * j + i] =
          -madd(taken[1][i], joints_chassis_[1][j], taken[0][i] * joints_chassis_[0][j]);
    result.right_side[i] = madd(taken[1][i], joint_residual_[1], taken[0][i] * joint_residual_[0]);
  }
  result.right_side[6] = result.right_side[7] = Lanes{};
  if (!any(kept_)) return;
  // Nothing is taken out for these: -0 leaves every sum as it is.
  for (Lanes& entry : result.matrix) entry = select(kept_, -Lanes{}, entry);
  for (Lanes& entry : result.right_side) entry = select(kept_, -Lanes{}, entry);
}

void CasterLanes::apply(const Vector6& step, Velocity& v) const {
  std::array<Lanes, 2> change;
  for (std::size_t k = 0; k < 2; ++k) {
    Lanes sum = joints_chassis_[k][0] * step[0];
    for (std::size_t i = 1; i < 6; ++i)
      sum = madd(joints_chassis_[k][i], same<Lanes>(step[static_cast<int>(i)]), sum);
    change[k] = joint_residual_[k] + sum;
  }
  const auto of_joint = [&](std::size_t k) {
    return madd(inverse_[1][k], change[1], inverse_[0][k] * change[0]);
  };
  const Lanes swivel = of_joint(0), axle = of_joint(1);
  for (std::size_t k = 0; k < count_; ++k) {
    if (kept(k)) continue;
    v.joints[first_ + k][0] -= swivel[k];
    v.joints[first_ + k][1] -= axle[k];
  }
}

Matrix2 CasterLanes::joints(std::size_t lane) const {
  Matrix2 result;
  result << joints_[0][0][lane], joints_[1][0][lane], joints_[0][1][lane], joints_[1][1][lane];
  return result;
}

Eigen::Matrix<double, 6, 2> CasterLanes::chassis_joints(std::size_t lane) const {
  Eigen::Matrix<double, 6, 2> result;
  for (std::size_t k = 0; k < 2; ++k)
    for (std::size_t i = 0; i < 6; ++i)
      result(static_cast<int>(i), static_cast<int>(k)) = chassis_joints_[k][i][lane];
  return result;
}

Eigen::Matrix<double, 2, 6> CasterLanes::joints_chassis(std::size_t lane) const {
  Eigen::Matrix<double, 2, 6> result;
  for (std::size_t k = 0; k < 2; ++k)
    for (std::size_t i = 0; i < 6; ++i)
      result(static_cast<int>(k), static_cast<int>(i)) = joints_chassis_[k][i][lane];
  return result;
}

void CasterLanes::add_slopes(std::size_t lane, const Eigen::Matrix<double, 6, 2>& chassis_joints,
                             const Eigen::Matrix<double, 2, 6>& joints_chassis,
                             const Matrix2& joints) {
  for (std::size_t k = 0; k < 2; ++k) {
    const int column = static_cast<int>(k);
    for (std::size_t i = 0; i < 6; ++i) {
      chassis_joints_[k][i][lane] += chassis_joints(static_cast<int>(i), column);
      joints_chassis_[k][i][lane] += joints_chassis(column, static_cast<int>(i));
    }
    for (std::size_t i = 0; i < 2; ++i) joints_[k][i][lane] += joints(static_cast<int>(i), column);
  }
}

}  // namespace gurney
