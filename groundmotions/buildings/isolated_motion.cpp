#include "groundmotions/buildings/isolated_motion.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "engine/base/units.h"

namespace gurney::groundmotions {

namespace {

constexpr int kMaxIterations = 200;
/// Error of a step relative to its displacement: all steps together miss at most this share of the
/// path, where halving the step leaves 1e-3 of the peak (floor_record.cpp). Energies close at any.
constexpr double kTolerance = 1e-10;

double load(const Isolation& isolation, double vertical) {
  return isolation.follows_vertical ? std::max(0.0, 1 + vertical / kStandardGravity) : 1.0;
}

}  // namespace

IsolatedMotion::ModeState::ModeState(const Mode& mode, double effective_mass, double time_step)
    : mass(effective_mass),
      step(time_step),
      viscosity(2 * mode.damping * mode.omega),
      stiffness(mode.omega * mode.omega),
      share(1 / (1 + step / 2 * (viscosity + step / 2 * stiffness))),
      shape(mode.effective_shape),
      rotation(mode.effective_rotation) {
  if (rotation.size() == 0) rotation = Eigen::VectorXd::Zero(shape.size());
}

IsolatedMotion::IsolatedMotion(const Isolation& isolation, const std::array<ModalAxis, 2>& axes,
                               double time_step)
    : isolation_(isolation), h_(time_step) {
  assert(time_step > 0 && isolation.base_mass_ratio > 0 && isolation.base_mass_ratio < 1);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    double inertia = free_mass_[axis] = 1;
    for (const Mode& mode : axes[axis]) {
      const double mass = (1 - isolation.base_mass_ratio) * mode.effective_mass;
      const ModeState& state = modes_[axis].emplace_back(mode, mass, h_);
      free_mass_[axis] -= mass;
      inertia -= mass * state.share;
    }
    inertia_[static_cast<Eigen::Index>(axis)] = inertia;
    assert(free_mass_[axis] > 0);
  }
}

double IsolatedMotion::largest_step(const Isolation& isolation,
                                    const std::array<ModalAxis, 2>& axes) {
  // With A = 2 B / h^2, B > base_mass_ratio, and J between 0 and s + r / h the slope of the mean
  // force over the increment, s = q / (2 u_y), r = rate (q_fast - q_slow), the fixed point
  // contracts by (s - J) / (A + s): by 1/2 or better for h^2 <= B / s and h <= B / r.
  const double share = isolation.base_mass_ratio;
  const double hysteresis = isolation.fast_strength / (2 * isolation.yield_displacement);
  const double rate = isolation.strength_rate * (isolation.fast_strength - isolation.slow_strength);
  double square = share / std::max(hysteresis, isolation.stiffness);
  if (rate > 0) square = std::min(square, std::pow(share / rate, 2));
  for (const ModalAxis& axis : axes)
    for (const Mode& mode : axis) square = std::min(square, 1 / (mode.omega * mode.omega));
  return std::sqrt(square);
}

void IsolatedMotion::release(const Vector2& displacement, const Vector2& velocity,
                             const Vector2& z) {
  u_ = displacement;
  v_ = velocity;
  z_ = z;
  energy_ = {};
  energy_.restoring = isolation_.stiffness * u_.squaredNorm() / 2;
  energy_.input = energy_.restoring + v_.squaredNorm() / 2;
}

void IsolatedMotion::step(const Vector3& ground0, const Vector3& ground1) {
  const Vector2 ground = (ground0 + ground1).head<2>() / 2;
  const double n = load(isolation_, (ground0.z() + ground1.z()) / 2);
  const double stiffness = n * isolation_.stiffness;
  const double uy = isolation_.yield_displacement;

  // Modes eliminated: A increment = b - n q mean(z), A diagonal.
  const Vector2 a =
      (2 / (h_ * h_) * inertia_.array() + isolation_.viscosity / h_ + stiffness / 2).matrix();
  Vector2 b = -stiffness * u_ - inertia_.cwiseProduct(ground - 2 / h_ * v_);
  for (std::size_t axis = 0; axis < 2; ++axis)
    for (const ModeState& mode : modes_[axis])
      b[static_cast<Eigen::Index>(axis)] += mode.mass * mode.share * mode.pull();

  // A fixed point of the push. The last increment is that of the last push, so the energies close
  // whatever the tolerance.
  const double slope = n * isolation_.fast_strength / (2 * uy);
  const Vector2 softness = (a.array() + slope).inverse().matrix();
  Vector2 increment = h_ * v_, push = Vector2::Zero();
  Sliding sliding{z_, z_};
  for (int i = 0; i < kMaxIterations; ++i) {
    sliding = slide(z_, increment / uy);
    push = n * isolation_.strength(increment.norm() / h_) * sliding.mean;
    const Vector2 next = softness.cwiseProduct(b - push + slope * increment);
    const double change = (next - increment).norm();
    increment = next;
    if (change <= kTolerance * (increment.norm() + h_ * v_.norm())) break;
  }

  const Vector2 acceleration = 2 / h_ * (increment / h_ - v_);
  energy_.input -= ground.dot(increment);
  energy_.restoring += stiffness * (u_ + increment / 2).dot(increment);
  energy_.hysteresis += push.dot(increment);
  energy_.damping += isolation_.viscosity * increment.squaredNorm() / h_;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto i = static_cast<Eigen::Index>(axis);
    energy_.input -= ground[i] * move_modes(axis, ground[i] + acceleration[i]);
  }
  u_ += increment;
  v_ += h_ * acceleration;
  z_ = sliding.end;
  load_ = load(isolation_, ground1.z());
  lifted_ = lifted_ || !(n > 0);
}

double IsolatedMotion::move_modes(std::size_t axis, double base_acceleration) {
  double moved = 0;
  for (ModeState& mode : modes_[axis]) {
    const double mean_velocity = mode.w - h_ / 2 * (base_acceleration + mode.pull()) * mode.share;
    mode.q += h_ * mean_velocity;
    mode.w += 2 * (mean_velocity - mode.w);
    moved += mode.mass * h_ * mean_velocity;
    energy_.damping += mode.mass * mode.viscosity * mean_velocity * mean_velocity * h_;
  }
  return moved;
}

Vector2 IsolatedMotion::force() const {
  return load_ * (isolation_.stiffness * u_ + isolation_.strength(v_.norm()) * z_) +
         isolation_.viscosity * v_;
}

Vector2 IsolatedMotion::floor_acceleration(Eigen::Index floor) const {
  // The base from the forces on it: free_mass a_base = -f - sum_i m_i (a_base + q_i'').
  Vector2 result = -force();
  for (int axis = 0; axis < 2; ++axis) {
    const auto& modes = modes_[static_cast<std::size_t>(axis)];
    for (const ModeState& mode : modes) result[axis] -= mode.mass * mode.absolute_acceleration();
    const double base = result[axis] / free_mass_[static_cast<std::size_t>(axis)];
    result[axis] = base;
    for (const ModeState& mode : modes)
      result[axis] += mode.shape[floor] * (mode.absolute_acceleration() - base);
  }
  return result;
}

double IsolatedMotion::storey_drift() const {
  double largest = 0;
  for (const std::vector<ModeState>& axis : modes_) {
    if (axis.empty()) continue;
    Eigen::VectorXd floors = Eigen::VectorXd::Zero(axis.front().shape.size());
    for (const ModeState& mode : axis) floors += mode.q * mode.shape;
    largest = std::max(largest, largest_storey_drift(floors));
  }
  return largest;
}

Vector2 IsolatedMotion::floor_dip(Eigen::Index floor) const {
  Vector2 dip = Vector2::Zero();
  for (int axis = 0; axis < 2; ++axis)
    for (const ModeState& mode : modes_[static_cast<std::size_t>(axis)])
      dip[axis] += mode.rotation[floor] * mode.q;
  return dip;
}

Vector2 IsolatedMotion::floor_dip_acceleration(Eigen::Index floor) const {
  const Vector2 base = floor_acceleration(0);
  Vector2 result = Vector2::Zero();
  for (int axis = 0; axis < 2; ++axis)
    for (const ModeState& mode : modes_[static_cast<std::size_t>(axis)])
      result[axis] += mode.rotation[floor] * (mode.absolute_acceleration() - base[axis]);
  return result;
}

IsolationEnergy IsolatedMotion::energy() const {
  IsolationEnergy energy = energy_;
  energy.kinetic = v_.squaredNorm() / 2;
  for (int axis = 0; axis < 2; ++axis)
    for (const ModeState& mode : modes_[static_cast<std::size_t>(axis)]) {
      energy.kinetic += mode.mass * mode.w * (v_[axis] + mode.w / 2);
      energy.strain += mode.mass * mode.stiffness * mode.q * mode.q / 2;
    }
  return energy;
}

}  // namespace gurney::groundmotions
