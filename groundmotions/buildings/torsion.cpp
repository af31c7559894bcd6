#include "groundmotions/buildings/torsion.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "engine/base/linear_algebra.h"
#include "groundmotions/buildings/modal_building.h"

namespace gurney::groundmotions {

TwistingMatrices twisting_matrices(const Eigen::VectorXd& mass,
                                   const Eigen::Matrix2Xd& eccentricity, double gyration,
                                   const std::array<Eigen::MatrixXd, 2>& stiffness,
                                   const Eigen::MatrixXd& torsional) {
  const Eigen::Index n = mass.size();
  const Eigen::VectorXd ex = eccentricity.row(0).transpose() / gyration,
                        ey = eccentricity.row(1).transpose() / gyration;
  const Eigen::VectorXd inertia =
      mass.cwiseProduct(Eigen::VectorXd::Ones(n) + ex.cwiseAbs2() + ey.cwiseAbs2());
  const auto diagonal = [](const Eigen::VectorXd& values) -> Eigen::MatrixXd {
    return values.asDiagonal();
  };
  const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(n, n);
  TwistingMatrices result{Eigen::MatrixXd(3 * n, 3 * n), Eigen::MatrixXd(3 * n, 3 * n),
                          Eigen::MatrixXd::Zero(3 * n, 2)};
  result.mass << diagonal(mass), none, diagonal(-mass.cwiseProduct(ey)),  //
      none, diagonal(mass), diagonal(mass.cwiseProduct(ex)),              //
      diagonal(-mass.cwiseProduct(ey)), diagonal(mass.cwiseProduct(ex)), diagonal(inertia);
  result.stiffness << stiffness[0], none, none,  //
      none, stiffness[1], none,                  //
      none, none, torsional;
  // A ground that moves along x or y carries every coordinate with it but theta.
  result.carried.block(0, 0, n, 1).setOnes();
  result.carried.block(n, 1, n, 1).setOnes();
  return result;
}

std::vector<TorsionMode> torsion_modes(const TorsionalBuilding& building) {
  const Eigen::Index n = building.mass.size();
  assert(n > 0 && building.mass.minCoeff() > 0 && building.gyration > 0 &&
         building.frequency_ratio > 0 && building.eccentricity.cols() == n);
  const double r = building.gyration, ratio = building.frequency_ratio;
  const auto [mass, stiffness, carried] =
      twisting_matrices(building.mass, building.eccentricity, r, building.stiffness,
                        ratio * ratio * building.stiffness[0]);
  const auto [squared_frequencies, shapes] = natural_modes(stiffness, mass);
  std::vector<TorsionMode> modes;
  for (Eigen::Index i = 0; i < 3 * n; ++i) {
    const Eigen::VectorXd shape = shapes.col(i);  // phi' M phi = 1
    TorsionMode mode;
    mode.omega = std::sqrt(squared_frequencies[i]);
    mode.participation = carried.transpose() * (mass * shape);
    mode.shape = Eigen::Matrix3Xd::Zero(3, n + 1);
    for (Eigen::Index row = 0; row < 3; ++row)
      mode.shape.row(row).tail(n) = shape.segment(row * n, n).transpose() / (row == 2 ? r : 1.0);
    modes.push_back(std::move(mode));
  }
  return modes;
}

TorsionResponse::TorsionResponse(const std::vector<TorsionMode>& modes, Eigen::Index floor,
                                 const Vector2& place, double time_step)
    : modes_(modes), floor_(floor), place_(place) {
  for (const TorsionMode& mode : modes) {
    assert(floor >= 0 && floor < mode.shape.cols());
    oscillators_.emplace_back(mode.omega, mode.damping, time_step);
  }
}

void TorsionResponse::step(const Vector2& ground0, const Vector2& ground1) {
  for (std::size_t i = 0; i < modes_.size(); ++i)
    oscillators_[i].step(-modes_[i].participation.dot(ground0),
                         -modes_[i].participation.dot(ground1));
}

Vector3 TorsionResponse::acceleration(const Vector2& ground) const {
  Vector3 result(ground.x(), ground.y(), 0);
  for (std::size_t i = 0; i < modes_.size(); ++i) {
    const TorsionMode& mode = modes_[i];
    const Oscillator& q = oscillators_[i];
    const Vector3 axis = mode.shape.col(floor_);
    const Vector2 moved = at_place(place_, axis);
    result -= Vector3(moved.x(), moved.y(), axis.z()) *
              (mode.participation.dot(ground) + 2 * mode.damping * mode.omega * q.velocity() +
               mode.omega * mode.omega * q.displacement());
  }
  return result;
}

double TorsionResponse::yaw() const {
  double angle = 0;
  for (std::size_t i = 0; i < modes_.size(); ++i)
    angle += modes_[i].shape(2, floor_) * oscillators_[i].displacement();
  return angle;
}

double TorsionResponse::storey_drift() const {
  if (modes_.empty()) return 0;
  Eigen::Matrix2Xd moved = Eigen::Matrix2Xd::Zero(2, modes_.front().shape.cols());
  for (std::size_t i = 0; i < modes_.size(); ++i)
    for (Eigen::Index floor = 0; floor < moved.cols(); ++floor)
      moved.col(floor) +=
          oscillators_[i].displacement() * at_place(place_, modes_[i].shape.col(floor));
  return std::max(largest_storey_drift(moved.row(0)), largest_storey_drift(moved.row(1)));
}

}  // namespace gurney::groundmotions
