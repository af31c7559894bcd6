#include "tests/peers/moreau.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "engine/base/units.h"
#include "tests/peers/cart_bodies.h"
#include "tests/peers/cone.h"

namespace gurney::peers {
namespace {

constexpr double kSettling = 2;  // before the motion, on a floor at rest [s]

using Jacobian = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 32, kMostRates>;
using Impulses = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 32, 1>;
using Delassus = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 32, 32>;

/// The spring and the damper of a tread over a step, from its compression d in the middle of it:
/// p_z = h N, N = offset - slope u_z.
struct Normal {
  double offset = 0, slope = 0;
};

/// The branch of N = k d + min(max(-c u, -k d), k d) for d - h u / 2 > 0 that holds at u.
Normal normal_law(const Tread& tread, double compression, double u, double time_step) {
  const double k = tread.normal_stiffness, half = 0.5 * time_step * k;
  const double elastic = k * compression - half * u, damping = -tread.normal_damping * u;
  if (damping >= elastic) return {2 * k * compression, 2 * half};
  return {k * compression, half + tread.normal_damping};
}

class Moreau {
 public:
  Moreau(const EquipmentModel& item, double time_step)
      : casters_(item.casters),
        bodies_(item, CartBodies::Held::kRigidly),
        h_(time_step),
        state_(bodies_.at_rest()) {
    impulses_.setZero(4 * static_cast<long>(casters_.size()));
  }

  const CartState& state() const { return state_; }

  void step(const Vector3& gravity) {
    state_.move(0.5 * h_);
    bodies_.evaluate(state_, gravity, equations_);
    const long rows = impulses_.size();
    Jacobian jacobian(rows, state_.rates.size());
    for (std::size_t i = 0; i < casters_.size(); ++i)
      jacobian.middleRows<4>(4 * static_cast<long>(i)) = equations_.wheels[i].jacobian;
    const Eigen::LDLT<RateMatrix> mass(equations_.mass);
    const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMostRates, 32> spread =
        mass.solve(jacobian.transpose());
    const Rates free = state_.rates + h_ * Rates(mass.solve(equations_.force));
    solve(jacobian * spread, jacobian * free);
    state_.rates = free + spread * impulses_;
    state_.move(0.5 * h_);
  }

 private:
  /// Gauss-Seidel until no impulse changes the velocity of its wheel by 1e-4 g h: wheels that stick
  /// against each other have impulses that are not determined, but velocities that are.
  void solve(const Delassus& delassus, const Impulses& free) {
    constexpr int kMost = 20000;
    Impulses u = free + delassus * impulses_;
    for (int n = 0; n < kMost; ++n) {
      double change = 0;
      for (std::size_t i = 0; i < casters_.size(); ++i)
        change = std::max(change, relax(i, delassus, u));
      if (change <= 1e-4 * kStandardGravity * h_) return;
    }
    throw std::runtime_error("the impulses of a step were not found");
  }

  /// New impulses of one wheel; returns by how much they change its velocity.
  double relax(std::size_t i, const Delassus& delassus, Impulses& u) {
    const long at = 4 * static_cast<long>(i);
    const Eigen::Matrix4d block = delassus.block<4, 4>(at, at);
    const Eigen::Vector4d old = impulses_.segment<4>(at), others = u.segment<4>(at) - block * old;
    const WheelPoint& wheel = equations_.wheels[i];
    Eigen::Vector4d impulse = Eigen::Vector4d::Zero();
    if (wheel.compression > 0) {
      const Normal law = normal_law(casters_[i].tread, wheel.compression, u[at + 2], h_);
      impulse = wheel_impulse(casters_[i], law, block, others);
    }
    const Eigen::Vector4d change = impulse - old, speed = block * change;
    impulses_.segment<4>(at) = impulse;
    u += delassus.middleCols<4>(at) * change;
    return std::max(speed.head<3>().norm(), casters_[i].wheel_radius * std::abs(speed[3]));
  }

  /// First as if the wheel did not roll, then with the whole rolling resistance.
  Eigen::Vector4d wheel_impulse(const Caster& c, const Normal& law, const Eigen::Matrix4d& block,
                                const Eigen::Vector4d& others) const {
    ContactBlock contact{block.topLeftCorner<3, 3>(), others.head<3>(), c.tread.kinetic_friction};
    contact.block(2, 2) += 1 / (h_ * law.slope);
    contact.start.z() -= law.offset / law.slope;
    Eigen::Vector4d impulse = Eigen::Vector4d::Zero();
    if (c.brake_torque > 0) {
      impulse.head<3>() = cone_impulse(contact);
      return impulse;
    }
    const Vector3 by_roll = block.col(3).head<3>();
    ContactBlock stuck = contact;
    stuck.block -= by_roll * by_roll.transpose() / block(3, 3);
    stuck.start -= by_roll * others[3] / block(3, 3);
    impulse.head<3>() = cone_impulse(stuck);
    impulse[3] = -(others[3] + by_roll.dot(impulse.head<3>())) / block(3, 3);
    const double length = std::copysign(c.tread.rolling_friction_length, impulse[3]);
    if (std::abs(impulse[3]) <= std::abs(length * impulse[2])) return impulse;
    contact.block.col(2) += length * by_roll;
    impulse.head<3>() = cone_impulse(contact);
    impulse[3] = length * impulse[2];
    return impulse;
  }

  std::vector<Caster> casters_;
  CartBodies bodies_;
  double h_;
  CartState state_;
  CartBodies::Equations equations_;
  Impulses impulses_;  ///< x, y, z and rolling of each wheel, of the last step
};

/// Of brakes and of rolling resistance that is not overcome (docs/theory/tread.md).
double held_stiffness(const Caster& c) {
  return 10 * c.tread.tangential_stiffness * c.wheel_radius * c.wheel_radius;
}

/// The tread law from the state at the start of a step.
class Explicit {
 public:
  Explicit(const EquipmentModel& item, double time_step)
      : casters_(item.casters),
        bodies_(item, CartBodies::Held::kBySprings),
        h_(time_step),
        state_(bodies_.at_rest()),
        treads_(casters_.size()) {}

  const CartState& state() const { return state_; }

  void step(const Vector3& gravity) {
    bodies_.evaluate(state_, gravity, equations_);
    for (std::size_t i = 0; i < casters_.size(); ++i) {
      const WheelPoint& wheel = equations_.wheels[i];
      equations_.force +=
          wheel.jacobian.transpose() *
          force(casters_[i], wheel.compression, wheel.jacobian * state_.rates, treads_[i]);
      const long axle = bodies_.joints()[i].axle;
      if (casters_[i].brake_torque > 0)
        equations_.force[axle] -= held_stiffness(casters_[i]) * state_.joints[axle - 6];
    }
    state_.rates += h_ * Rates(equations_.mass.ldlt().solve(equations_.force));
    state_.move(h_);
  }

 private:
  struct Memory {
    Vector2 deflection = Vector2::Zero();
    double roll_deflection = 0;
    bool rolls = false;
  };

  /// Of the floor on the wheel; the memory moves on by a step.
  Eigen::Vector4d force(const Caster& c, double compression, const Eigen::Vector4d& u,
                        Memory& memory) const {
    const Tread& t = c.tread;
    const double elastic = t.normal_stiffness * compression;
    const double most = std::max(0.0, elastic);
    const double normal = most + std::clamp(-t.normal_damping * u[2], -most, most);
    if (normal <= 0) {
      memory = {};
      return Eigen::Vector4d::Zero();
    }
    const double k = t.tangential_stiffness, damping = t.tangential_damping;
    const double forgets = memory.rolls ? c.wheel_radius * std::abs(u[3]) / t.relaxation_length : 0;
    Vector2 rate = u.head<2>() - forgets * memory.deflection;
    Vector2 patch = -k * memory.deflection - damping * rate;
    const double limit = t.kinetic_friction * normal;
    if (patch.norm() > limit) {
      patch *= limit / patch.norm();
      rate = (-patch - k * memory.deflection) / damping;
    }
    memory.deflection += h_ * rate;
    const double stuck = held_stiffness(c);
    const double trial = -stuck * (memory.roll_deflection + h_ * u[3]);
    const double resistance = t.rolling_friction_length * normal;
    const double roll = std::clamp(trial, -resistance, resistance);
    memory.rolls = roll != trial;
    memory.roll_deflection = -roll / stuck;
    return {patch.x(), patch.y(), normal, roll};
  }

  std::vector<Caster> casters_;
  CartBodies bodies_;
  double h_;
  CartState state_;
  CartBodies::Equations equations_;
  std::vector<Memory> treads_;
};

template <class Method>
Path path_by(const CrossCheck& check, double time_step) {
  Method cart(check.scene.items[0].model, time_step);
  const Vector3 gravity = -check.scene.gravity * Vector3::UnitZ();
  const long settling = std::lround(kSettling / time_step);
  for (long k = 0; k < settling; ++k) cart.step(gravity);
  const auto pose = [&] {
    return snapshot(cart.state().origin, cart.state().rotation.toRotationMatrix());
  };
  const long stride = std::lround(check.sampling / time_step);
  const long steps = std::lround(check.duration / time_step);
  Path path{pose()};
  for (long k = 0; k < steps; ++k) {
    const double t = static_cast<double>(k) * time_step;
    cart.step(gravity -
              (check.floor.velocity_at(t + time_step) - check.floor.velocity_at(t)) / time_step);
    if ((k + 1) % stride != 0) continue;
    path.push_back(pose());
    if (path.back().tilt > kOverturned) break;
  }
  return path;
}

}  // namespace

Path moreau_path(const CrossCheck& check, double time_step) {
  return path_by<Moreau>(check, time_step);
}

Path explicit_path(const CrossCheck& check, double time_step) {
  return path_by<Explicit>(check, time_step);
}

}  // namespace gurney::peers
