#include "studies/verification/scenes/small_scenes.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/linear_algebra.h"
#include "engine/base/units.h"

namespace gurney::small {
namespace {

/// splitmix64 (Steele, Lea & Flood 2014), as a number in [-1, 1).
double uniform(std::uint64_t& state) {
  std::uint64_t z = (state += 0x9E3779B97F4A7C15ull);
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
  return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-52 - 1;
}

}  // namespace

Tread bare_tread(double normal_stiffness, double tangential_stiffness) {
  return {.normal_stiffness = normal_stiffness,
          .normal_damping = 0,
          .tangential_stiffness = tangential_stiffness,
          .tangential_damping = 0,
          .relaxation_length = 0.01,
          .patch_width = 0,
          .rolling_friction_length = 0,
          .static_friction = 0.6,
          .kinetic_friction = 0.6};
}

Caster caster(const Vector3& mount, double heading_degrees, const Tread& tread, double trail) {
  Caster c;
  c.name = "caster";
  c.mount = mount;
  c.height = mount.z();
  c.heading = heading_degrees * kRadiansPerDegree;
  c.trail = trail;
  c.wheel_axial_inertia = 3.2e-4;
  c.wheel_transverse_inertia = 1.8e-4;
  c.fork_center_of_mass = {-trail / 2, 0, -0.05};
  c.fork_inertia = Vector3(2e-4, 2.2e-4, 1e-4).asDiagonal();
  c.tread = tread;
  return c;
}

double swivel_inertia(const Caster& c) {
  return c.fork_inertia(2, 2) + c.fork_mass * c.fork_center_of_mass.head<2>().squaredNorm() +
         c.wheel_transverse_inertia + c.wheel_mass * c.trail * c.trail;
}

EquipmentModel item_on(const std::vector<Vector2>& mounts, const std::vector<double>& headings,
                       const Tread& tread) {
  EquipmentModel item;
  item.name = "item";
  item.chassis_mass = 94.5;
  item.chassis_center_of_mass = {0, 0, 0.5};
  item.chassis_inertia = solid_box_inertia(94.5, {1.0, 0.5, 0.7});
  item.shape = {{{0, 0, 0.55}, {1.0, 0.5, 0.7}}};
  item.marked_points = {{"top", {0.3, 0.2, 0.9}}};
  for (std::size_t i = 0; i < mounts.size(); ++i)
    item.casters.push_back(caster({mounts[i].x(), mounts[i].y(), 0.131}, headings[i], tread));
  return item;
}

EquipmentModel trolley(const std::vector<double>& headings, const Tread& tread) {
  return item_on({{0.4, 0.2}, {0.4, -0.2}, {-0.4, 0.2}, {-0.4, -0.2}}, headings, tread);
}

Scene towed_caster(double speed, double trail, double heading, const Tread& tread) {
  Scene scene = scene_of(item_on({{0, 0}}, {heading}, tread));
  PlacedItem& item = scene.items[0];
  item.model.casters = {caster({0, 0, 0.131}, heading, tread, trail)};
  item.initial.velocity = {speed, 0, 0};
  for (int dof : {1, 3, 4, 5}) item.fixture.guides[dof].kind = Guide::Kind::kHeld;
  item.fixture.guides[0] = {Guide::Kind::kVelocity, speed, 0, 0};
  return scene;
}

SimulationSettings settings_for(double time_step, double duration, int stride) {
  SimulationSettings settings;
  settings.time_step = time_step;
  settings.duration = duration;
  settings.history_step = stride * time_step;
  return settings;
}

FloorMotion noise_record(std::uint64_t seed, double duration, const Vector3& peaks) {
  constexpr double kStep = 0.01, kDamping = 0.3;
  const int count = static_cast<int>(std::lround(duration / kStep)) + 1;
  Eigen::Matrix3Xd acceleration(3, count);
  for (int axis = 0; axis < 3; ++axis) {
    const double omega = 2 * std::numbers::pi * (axis < 2 ? 1.5 : 8);
    double x = 0, v = 0;
    for (int i = 0; i < count; ++i) {
      v += kStep * (omega * omega * (uniform(seed) - x) - 2 * kDamping * omega * v);
      x += kStep * v;
      const double s = static_cast<double>(i) / (count - 1);
      acceleration(axis, i) = v * std::min({1.0, 4 * s, 4 * (1 - s)});
    }
    acceleration.row(axis) *= peaks[axis] / acceleration.row(axis).cwiseAbs().maxCoeff();
  }
  return FloorMotion(kStep, acceleration);
}

Eigen::VectorXcd exponents(const std::vector<double>& samples, double step, int order) {
  const auto rows = static_cast<Eigen::Index>(samples.size()) - order;
  Eigen::MatrixXd past(rows, order);
  Eigen::VectorXd next(rows);
  for (Eigen::Index n = 0; n < rows; ++n) {
    for (int k = 0; k < order; ++k) past(n, k) = samples[static_cast<std::size_t>(n + k)];
    next[n] = samples[static_cast<std::size_t>(n + order)];
    const double scale = past.row(n).norm();
    past.row(n) /= scale;
    next[n] /= scale;
  }
  Eigen::MatrixXd companion = Eigen::MatrixXd::Zero(order, order);
  companion.topRightCorner(order - 1, order - 1).setIdentity();
  companion.row(order - 1) = pivoted_least_squares(past, next).transpose();
  return eigenvalues(companion).array().log() / step;
}

Eigen::MatrixXd sdirk_step(const Eigen::MatrixXd& a, double step) {
  const double gamma = 1 - std::sqrt(0.5);
  const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(a.rows(), a.cols());
  const Eigen::MatrixXd implicit = (one - gamma * step * a).inverse();
  return (one + (1 - 2 * gamma) * step * a) * implicit * implicit;
}

}  // namespace gurney::small
