#include "groundmotions/buildings/modal_building.h"

#include <cassert>
#include <cmath>
#include <numbers>

#include "engine/base/linear_algebra.h"

namespace gurney::groundmotions {

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

}  // namespace

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

}  // namespace gurney::groundmotions
