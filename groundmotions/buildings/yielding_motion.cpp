#include "groundmotions/buildings/yielding_motion.h"

#include <algorithm>
#include <cassert>

#include "groundmotions/buildings/isolation.h"
#include "groundmotions/buildings/modal_building.h"

namespace gurney::groundmotions {
namespace {

constexpr int kMaxIterations = 100;
/// Change of the mean velocity at which a solve ends, over its size: rounding is 1e-16, and floor motions
/// are wanted to 1e-3 (floor_record.cpp).
constexpr double kTolerance = 1e-12;

/// B u: differences of floors that follow each other, the ground being 0.
Eigen::VectorXd drifts(const Eigen::VectorXd& floors) {
  Eigen::VectorXd result = floors;
  result.tail(floors.size() - 1) -= floors.head(floors.size() - 1);
  return result;
}

/// B' V: the force of the storeys below and above on each floor.
Eigen::VectorXd on_floors(const Eigen::VectorXd& shears) {
  Eigen::VectorXd result = shears;
  result.head(shears.size() - 1) -= shears.tail(shears.size() - 1);
  return result;
}

/// C of a damping ratio for each mode.
Eigen::MatrixXd modal_damping(const Eigen::VectorXd& mass, const Eigen::MatrixXd& stiffness,
                              const Eigen::VectorXd& ratios) {
  const auto [squared_frequencies, shapes] = natural_modes(stiffness, mass.asDiagonal());
  const Eigen::MatrixXd momenta = mass.asDiagonal() * shapes;
  const Eigen::VectorXd viscosities = 2 * ratios.array() * squared_frequencies.array().sqrt();
  return momenta * viscosities.asDiagonal() * momenta.transpose();
}

}  // namespace

YieldingMotion::Axis YieldingMotion::axis_of(std::size_t a) const {
  const Eigen::VectorXd& mass = storeys_.mass;
  const Eigen::MatrixXd stiffness = shear_stiffness(storeys_.stiffness[a]);
  const Eigen::MatrixXd damping = modal_damping(mass, stiffness, storeys_.damping[a]);
  const Eigen::MatrixXd inertia = (2 / h_ * mass).asDiagonal();
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(mass.size());
  return {storeys_.stiffness[a], rest, rest, damping,
          SymmetricFactors(inertia + damping + h_ / 2 * stiffness)};
}

YieldingMotion::YieldingMotion(const YieldingStoreys& storeys, double time_step)
    : storeys_(storeys),
      h_(time_step),
      axes_{axis_of(0), axis_of(1)},
      drift_(Eigen::Matrix2Xd::Zero(2, storeys.mass.size())),
      z_(drift_),
      next_z_(drift_) {
  assert(time_step > 0 && storeys.hardening >= 0 && storeys.hardening < 1);
}

double YieldingMotion::shear(Eigen::Index storey, Eigen::Index a, double drift, double z) const {
  const double alpha = storeys_.hardening;
  return axes_[static_cast<std::size_t>(a)].stiffness[storey] *
         (alpha * drift + (1 - alpha) * storeys_.yield_drift[storey] * z);
}

Eigen::Matrix2Xd YieldingMotion::mean_shear(const Eigen::Matrix2Xd& increment) {
  Eigen::Matrix2Xd result(2, increment.cols());
  for (Eigen::Index i = 0; i < increment.cols(); ++i) {
    const Sliding slid = slide(z_.col(i), increment.col(i) / storeys_.yield_drift[i]);
    next_z_.col(i) = slid.end;
    for (Eigen::Index a = 0; a < 2; ++a)
      result(a, i) = shear(i, a, drift_(a, i) + increment(a, i) / 2, slid.mean[a]);
  }
  return result;
}

void YieldingMotion::step(const Vector2& ground0, const Vector2& ground1) {
  const Eigen::VectorXd& mass = storeys_.mass;
  const Vector2 ground = (ground0 + ground1) / 2;
  Eigen::Matrix2Xd increment(2, mass.size()), shears;
  // The elastic slope is the largest that mean shears have: with it the fixed point contracts, by
  // (omega h / 2)^2 / (1 + (omega h / 2)^2) at most.
  for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
    for (Eigen::Index a = 0; a < 2; ++a)
      increment.row(a) = h_ * drifts(axes_[static_cast<std::size_t>(a)].mean_velocity).transpose();
    shears = mean_shear(increment);
    double change = 0, size = 0;
    for (Eigen::Index a = 0; a < 2; ++a) {
      Axis& axis = axes_[static_cast<std::size_t>(a)];
      const Eigen::VectorXd residual =
          mass.cwiseProduct(2 / h_ * (axis.mean_velocity - axis.velocity)) +
          axis.damping * axis.mean_velocity + on_floors(shears.row(a).transpose()) +
          ground[a] * mass;
      const Eigen::VectorXd correction = axis.solve.solve(residual);
      axis.mean_velocity -= correction;
      change = std::max(change, correction.cwiseAbs().maxCoeff());
      size = std::max(size, axis.mean_velocity.cwiseAbs().maxCoeff());
    }
    if (change <= kTolerance * size) break;
  }
  for (Eigen::Index a = 0; a < 2; ++a)
    increment.row(a) = h_ * drifts(axes_[static_cast<std::size_t>(a)].mean_velocity).transpose();
  shears = mean_shear(increment);

  energy_.kinetic = energy_.strain = 0;
  const Eigen::Matrix2Xd end = drift_ + increment;
  for (Eigen::Index a = 0; a < 2; ++a) {
    Axis& axis = axes_[static_cast<std::size_t>(a)];
    const Eigen::VectorXd& mean = axis.mean_velocity;
    axis.velocity = 2 * mean - axis.velocity;
    energy_.input -= h_ * ground[a] * mass.dot(mean);
    energy_.damping += h_ * mean.dot(axis.damping * mean);
    energy_.kinetic += mass.dot(axis.velocity.cwiseAbs2()) / 2;
    for (Eigen::Index i = 0; i < mass.size(); ++i) {
      const double elastic = storeys_.hardening * axis.stiffness[i];
      energy_.strain += elastic * end(a, i) * end(a, i) / 2;
      energy_.hysteresis +=
          (shears(a, i) - elastic * (drift_(a, i) + end(a, i)) / 2) * increment(a, i);
    }
  }
  drift_ = end;
  z_ = next_z_;
}

Vector2 YieldingMotion::floor_acceleration(Eigen::Index floor) const {
  const Eigen::Index i = floor - 1;
  Vector2 result;
  for (Eigen::Index a = 0; a < 2; ++a) {
    const Axis& axis = axes_[static_cast<std::size_t>(a)];
    double force = -axis.damping.row(i).dot(axis.velocity) - shear(i, a, drift_(a, i), z_(a, i));
    if (floor < drift_.cols()) force += shear(floor, a, drift_(a, floor), z_(a, floor));
    result[a] = force / storeys_.mass[i];
  }
  return result;
}

}  // namespace gurney::groundmotions
