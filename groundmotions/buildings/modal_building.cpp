#include "groundmotions/buildings/modal_building.h"

#include <Eigen/LU>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "engine/base/linear_algebra.h"

namespace gurney::groundmotions {
namespace {

/// Slope of the parabola through a floor and its two neighbours, or the two floors next to the roof.
Eigen::VectorXd slopes(const Eigen::VectorXd& shape, double storey) {
  const Eigen::Index roof = shape.size() - 1;
  Eigen::VectorXd slope = Eigen::VectorXd::Zero(shape.size());
  for (Eigen::Index i = 1; i < roof; ++i) slope[i] = (shape[i + 1] - shape[i - 1]) / (2 * storey);
  // Below the base the shape of a clamped building is even about it.
  const double below = roof > 1 ? shape[roof - 2] : shape[1];
  slope[roof] = (3 * shape[roof] - 4 * shape[roof - 1] + below) / (2 * storey);
  return slope;
}

ModalAxis slab_modes(int storeys, const VerticalFloors& floors) {
  Mode slab;
  slab.omega = floors.floor_omega;
  slab.effective_shape = Eigen::VectorXd::Constant(storeys + 1, floors.participation);
  slab.effective_shape[0] = 0;
  slab.effective_mass = floors.mass_share;
  return {slab};
}

}  // namespace

ModalAxis modes_of(const Eigen::VectorXd& mass, const Eigen::MatrixXd& stiffness,
                   const Eigen::MatrixXd& floors) {
  assert(mass.size() > 0 && mass.minCoeff() > 0 && stiffness.rows() == mass.size());
  const auto [squared_frequencies, shapes] = natural_modes(stiffness, mass.asDiagonal());
  assert(squared_frequencies[0] > 0);
  ModalAxis axis;
  for (Eigen::Index i = 0; i < mass.size(); ++i) {
    const Eigen::VectorXd shape = shapes.col(i);  // phi' M phi = 1
    const double participation = shape.dot(mass);
    Mode mode;
    mode.omega = std::sqrt(squared_frequencies[i]);
    mode.effective_shape = Eigen::VectorXd::Zero(floors.rows() + 1);
    mode.effective_shape.tail(floors.rows()) = participation * floors * shape;
    mode.effective_mass = participation * participation / mass.sum();
    axis.push_back(std::move(mode));
  }
  return axis;
}

ModalAxis modes_of(const Eigen::VectorXd& mass, const Eigen::MatrixXd& stiffness) {
  return modes_of(mass, stiffness, Eigen::MatrixXd::Identity(mass.size(), mass.size()));
}

void scale_to_period(ModalAxis& axis, double period) {
  assert(!axis.empty() && period > 0);
  const double factor = 2 * std::numbers::pi / period / axis.front().omega;
  for (Mode& mode : axis) mode.omega *= factor;
}

void set_damping(ModalAxis& axis, double ratio) {
  for (Mode& mode : axis) mode.damping = ratio;
}

double rotation_of(const Mode& mode, Eigen::Index floor) {
  return mode.effective_rotation.size() > 0 ? mode.effective_rotation[floor] : 0.0;
}

void set_rotation(ModalAxis& axis, double height, double share) {
  for (Mode& mode : axis) {
    const auto storeys = static_cast<double>(mode.effective_shape.size() - 1);
    mode.effective_rotation = share * slopes(mode.effective_shape, height / storeys);
  }
}

void set_rayleigh_damping(ModalAxis& axis, double ratio, std::size_t first, std::size_t second) {
  const double a = axis.at(first).omega, b = axis.at(second).omega;
  for (Mode& mode : axis) mode.damping = ratio / (a + b) * (a * b / mode.omega + mode.omega);
}

ModalResponse::ModalResponse(const ModalAxis& axis, Eigen::Index floor, double time_step)
    : axis_(axis), floor_(floor) {
  for (const Mode& mode : axis) {
    assert(floor >= 0 && floor < mode.effective_shape.size());
    rigid_share_ -= mode.effective_shape[floor];
    oscillators_.emplace_back(mode.omega, mode.damping, time_step);
  }
}

double ModalResponse::step(double base0, double base1) {
  double acceleration = rigid_share_ * base1;
  for (std::size_t i = 0; i < axis_.size(); ++i) {
    const Mode& mode = axis_[i];
    Oscillator& q = oscillators_[i];
    q.step(-base0, -base1);
    acceleration -= mode.effective_shape[floor_] * (2 * mode.damping * mode.omega * q.velocity() +
                                                    mode.omega * mode.omega * q.displacement());
  }
  return acceleration;
}

double largest_storey_drift(const Eigen::VectorXd& floors) {
  const Eigen::Index storeys = floors.size() - 1;
  return (floors.tail(storeys) - floors.head(storeys)).cwiseAbs().maxCoeff();
}

double ModalResponse::storey_drift() const {
  if (axis_.empty()) return 0;
  Eigen::VectorXd floors = Eigen::VectorXd::Zero(axis_.front().effective_shape.size());
  for (std::size_t i = 0; i < axis_.size(); ++i)
    floors += oscillators_[i].displacement() * axis_[i].effective_shape;
  return largest_storey_drift(floors);
}

double ModalResponse::rotation() const {
  double angle = 0;
  for (std::size_t i = 0; i < axis_.size(); ++i)
    angle += rotation_of(axis_[i], floor_) * oscillators_[i].displacement();
  return angle;
}

double ModalResponse::rotation_acceleration(double base) const {
  double result = 0;
  for (std::size_t i = 0; i < axis_.size(); ++i) {
    const Mode& mode = axis_[i];
    const Oscillator& q = oscillators_[i];
    result -= rotation_of(mode, floor_) * (base + 2 * mode.damping * mode.omega * q.velocity() +
                                           mode.omega * mode.omega * q.displacement());
  }
  return result;
}

Eigen::MatrixXd shear_stiffness(const Eigen::VectorXd& storeys) {
  const Eigen::Index n = storeys.size();
  assert(n > 0 && storeys.minCoeff() > 0);
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    stiffness(i, i) += storeys[i];
    if (i == 0) continue;
    stiffness(i - 1, i - 1) += storeys[i];
    stiffness(i - 1, i) -= storeys[i];
    stiffness(i, i - 1) -= storeys[i];
  }
  return stiffness;
}

Eigen::VectorXd tapered_storeys(int storeys, double top_ratio) {
  if (storeys == 1) return Eigen::VectorXd::Ones(1);
  return Eigen::VectorXd::LinSpaced(storeys, 1, top_ratio);
}

Eigen::MatrixXd shear_flexure_stiffness(int storeys, double alpha0) {
  assert(storeys > 0 && alpha0 >= 0);
  const Eigen::MatrixXd shear = shear_stiffness(Eigen::VectorXd::Constant(storeys, storeys));
  if (std::isinf(alpha0)) return shear;
  Eigen::MatrixXd flexibility(storeys, storeys);
  for (int i = 0; i < storeys; ++i)
    for (int j = 0; j < storeys; ++j) {
      const double low = (std::min(i, j) + 1.0) / storeys, high = (std::max(i, j) + 1.0) / storeys;
      flexibility(i, j) = low * low * (3 * high - low) / 6;
    }
  const Eigen::MatrixXd bending = flexibility.inverse();
  return (bending + bending.transpose()) / 2 + alpha0 * alpha0 * shear;
}

using std::numbers::pi;

double approximate_period(const FrameKind& frame, double height) {
  assert(height > 0);
  return frame.coefficient * std::pow(height, frame.exponent);
}

double plate_mass_share() { return std::pow(8 / (pi * pi), 2); }
double plate_participation() { return std::pow(4 / pi, 2); }

ModalAxis vertical_modes(int storeys, const VerticalFloors& floors) {
  assert(storeys > 0 && floors.floor_omega > 0 && floors.column_omega > 0);
  ModalAxis axis;
  if (std::isinf(floors.column_omega)) {
    axis = slab_modes(storeys, floors);
  } else {
    const Eigen::Index n = storeys;
    const auto ones = Eigen::VectorXd::Ones(n);
    ModalAxis rigid_slabs = modes_of(ones, shear_stiffness(ones));
    const double storey = std::pow(floors.column_omega / rigid_slabs.front().omega, 2);
    const double slab = floors.mass_share * floors.floor_omega * floors.floor_omega;
    const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(n, n);
    Eigen::VectorXd mass(2 * n);  // columns, then slabs
    mass << (1 - floors.mass_share) * ones, floors.mass_share * ones;
    Eigen::MatrixXd stiffness(2 * n, 2 * n), place(n, 2 * n);
    stiffness << storey * shear_stiffness(ones) + slab * identity, -slab * identity,
        -slab * identity, slab * identity;
    place << (1 - floors.participation) * identity, floors.participation * identity;
    axis = modes_of(mass, stiffness, place);
  }
  set_damping(axis, floors.damping);
  return axis;
}

}  // namespace gurney::groundmotions
